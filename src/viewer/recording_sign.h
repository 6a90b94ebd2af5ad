// That the camera is being recorded.
#pragma once

namespace nullscope::viewer {

// In the right upper corner of the picture's part from `left` to `right`, below `top`; where that is narrow, in the menu bar. Between
// NewFrame and Render. Returns how high it is over the picture.
float draw_recording_sign(double recorded_s, float left, float right, float top);

}  // namespace nullscope::viewer
