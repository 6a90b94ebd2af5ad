// That the camera is being recorded, over the picture.
#pragma once

namespace nullscope::viewer {

// With its right upper corner at a place of the window, between NewFrame and Render. Returns how high it is.
float draw_recording_sign(double recorded_s, float right, float top);

}  // namespace nullscope::viewer
