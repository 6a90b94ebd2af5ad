// The camera's clock and the shift of light from far away, over the picture.
#pragma once
#include "viewer/view_state.h"

namespace nullscope::viewer {

// What exists at the camera's place, in the left upper corner of the picture's part from `left` to `right`, below `top`; nothing where that
// is too narrow. Between NewFrame and Render. Returns where its right edge is.
float draw_clock_overlay(const ViewState& view, float left, float right, float top);

}  // namespace nullscope::viewer
