// The reference as exact trace, without delays, of which no error is formed. Of scenes that it takes: a ray that it refuses is one that meets nothing.
#pragma once
#include <array>
#include <utility>
#include <vector>

#include "compare/ray_metrics.h"
#include "reference/reference.h"

namespace nullscope::cli {

inline ExactTrace exact_trace(const Scene& scene) {
    return [scene](const std::vector<std::array<double, 2>>& positions) {
        auto pixels = reference::trace_pixels(scene, positions, false);
        return pixels ? std::move(*pixels) : std::vector<RayPixel>(positions.size());
    };
}

}  // namespace nullscope::cli
