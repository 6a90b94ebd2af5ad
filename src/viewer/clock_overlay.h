// The camera's clock and the shift of light from far away, over the picture.
#pragma once
#include <string>
#include <vector>

#include "viewer/overlay.h"

namespace nullscope::viewer {

// What exists of it at the camera's place, for this overlay and for Numbers.
struct ClockRow {
    const char *name, *short_name;
    std::string value;
    const char* help;
};
std::vector<ClockRow> clock_rows(const ViewState& view, const Spacetime& spacetime);

// Those rows; nothing where there is too little room for them.
extern const Overlay kClockOverlay;

}  // namespace nullscope::viewer
