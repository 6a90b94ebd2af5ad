// The reference as exact trace. Of scenes that it takes: a ray that it refuses is one that meets nothing.
#pragma once
#include <map>
#include <memory>

#include "compare/ray_metrics.h"
#include "reference/reference.h"

namespace nullscope::cli {

inline ExactTrace exact_trace(const Scene& scene) {
    return [scene](const std::vector<std::array<double, 2>>& positions) {
        auto pixels = reference::trace_pixels(scene, positions);
        return pixels ? std::move(*pixels) : std::vector<RayPixel>(positions.size());
    };
}

// Each ray is traced once, however many methods are measured against it. Memory: some 200 bytes a ray.
inline ExactTrace remembered_trace(const Scene& scene) {
    const auto known = std::make_shared<std::map<std::array<double, 2>, RayPixel>>();
    return [known, scene](const std::vector<std::array<double, 2>>& positions) {
        std::vector<std::array<double, 2>> wanted;
        for (const auto& at : positions)
            if (!known->contains(at)) wanted.push_back(at);
        const auto pixels = exact_trace(scene)(wanted);
        for (std::size_t i = 0; i < wanted.size(); ++i) (*known)[wanted[i]] = pixels[i];
        std::vector<RayPixel> result;
        result.reserve(positions.size());
        for (const auto& at : positions) result.push_back(known->at(at));
        return result;
    };
}

}  // namespace nullscope::cli
