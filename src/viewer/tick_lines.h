// Ticks along the electric vector over the picture in the window (annotate/ticks.h).
#pragma once
#include "image/image.h"

namespace nullscope::viewer {

// stokes: of the picture on the screen, of the size of its ticks; empty: nothing. Between NewFrame and Render, behind the panels.
void draw_tick_lines(const Image<float>& stokes);

}  // namespace nullscope::viewer
