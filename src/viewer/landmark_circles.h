// Radii with names that the probe draws: circles about the centre, and their legend.
#pragma once
#include <vector>

#include "spacetime/spacetime.h"

namespace nullscope::viewer {

struct LandmarkCircle {
    const char* name;
    double r, areal;  // the metric's own radius; that of the circle, r_s
    unsigned colour;  // ImGui's
    bool filled;      // where light ends
};

// From the inside outward, those that exist. About a rotating hole in the equatorial plane, orbits with the rotation. 20 us.
std::vector<LandmarkCircle> landmark_circles(const Spacetime& spacetime);

// About `middle`, `scale` units a r_s, in the current window; `scale` > 0.
void draw_circles(const std::vector<LandmarkCircle>& circles, float middle_x, float middle_y, float scale);
// Names beside samples of their colours, in lines of at most this width in the current window.
void draw_legend(const std::vector<LandmarkCircle>& circles, float width);
// How high draw_legend() is.
float legend_height(const std::vector<LandmarkCircle>& circles, float width);

}  // namespace nullscope::viewer
