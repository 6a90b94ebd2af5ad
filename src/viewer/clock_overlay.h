// The camera's clock and the shift of light from far away, over the picture.
#pragma once
#include <string>
#include <vector>

#include "studio/view_state.h"

namespace nullscope::viewer {

// What exists of it at the camera's place, for this overlay and for Numbers.
struct ClockRow {
    const char *name, *short_name;
    std::string value;
    const char* help;
};
std::vector<ClockRow> clock_rows(const ViewState& view, const Spacetime& spacetime);

// Those rows in the left upper corner of the picture's part from `left` to `right`, below `top`; nothing where that
// is too narrow. Between NewFrame and Render. Returns where its right edge is.
float draw_clock_overlay(const ViewState& view, float left, float right, float top);

}  // namespace nullscope::viewer
