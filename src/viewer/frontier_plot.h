// Error against cost of every measured method, for the frame on the screen.
#pragma once
#include <optional>
#include <vector>

#include "render/frontier.h"
#include "scene/scene.h"

namespace nullscope::viewer {

struct FrontierPlot {
    const std::vector<MeasuredMethod>& measured;
    const Scene& scene;              // whose metric's methods are shown, in px of its frame
    Method method;                   // of the frame
    std::optional<double> asked_px;  // a line across
    std::optional<double> true_px;   // what was measured of the frame itself
};

// Takes its place in the window's column. A point under the pointer says its name and its numbers.
void draw_frontier_plot(const FrontierPlot& plot);

}  // namespace nullscope::viewer
