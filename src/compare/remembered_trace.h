// Exact rays that are asked for more than once.
#pragma once
#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "compare/ray_metrics.h"

namespace nullscope {

// Each ray is traced once however often it is asked for: for several frames of one camera. Not for several threads. Memory: some 200 bytes a
// ray.
inline ExactTrace remembered(ExactTrace trace) {
    using Place = std::array<double, 2>;
    const auto known = std::make_shared<std::map<Place, RayPixel>>();
    return [trace = std::move(trace), known](const std::vector<Place>& positions) {
        std::vector<Place> others;
        std::ranges::copy_if(positions, std::back_inserter(others),
                             [&](const Place& place) { return !known->contains(place); });
        const std::vector<RayPixel> traced = others.empty() ? std::vector<RayPixel>() : trace(others);
        for (std::size_t i = 0; i < others.size(); ++i) known->emplace(others[i], traced[i]);
        std::vector<RayPixel> pixels;
        pixels.reserve(positions.size());
        for (const Place& place : positions) pixels.push_back(known->at(place));
        return pixels;
    };
}

}  // namespace nullscope
