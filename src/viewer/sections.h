// The sections of the side panel. Each edits what it shows and returns true when the scene changed.
#pragma once
#include "viewer/view_state.h"

namespace nullscope::viewer {

// escape: the key was just pressed; an open list takes it.
bool scene_section(ViewState& view, bool escape);
bool camera_section(ViewState& view);
bool boost_section(ViewState& view);
bool fall_section(ViewState& view);
bool clock_section(ViewState& view);
inline constexpr double kClockStep_s = 0.1;
bool step_clock(ViewState& view, double dt_s);  // the scene's clock goes on; true if anything moved
bool lens_section(ViewState& view);
bool disc_section(ViewState& view);
bool sky_section(ViewState& view, bool escape);
bool light_section(ViewState& view, bool escape);
bool spacetime_section(ViewState& view, bool escape);

}  // namespace nullscope::viewer
