// The critical curve as a line over the picture in the window.
#pragma once
#include "scene/scene.h"

namespace nullscope::viewer {

inline constexpr const char* kCriticalCurveHelp =
    "Critical curve: directions whose light spirals to the photon sphere.";
inline constexpr unsigned kCriticalColour = 0xff96ff78u;  // ImGui's order: alpha, blue, green, red

// Of the scene on the screen, either half of a split one; behind the panels, in the current frame of Dear ImGui. Under a millisecond.
void draw_critical_curve(const Scene& scene);

bool has_critical_curve(const Scene& scene);  // in its spacetime, or in either half's

}  // namespace nullscope::viewer
