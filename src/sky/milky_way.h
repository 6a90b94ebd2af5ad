// The Milky Way: the equirectangular map of surface brightness that ships, smoothed onto a cube map's faces.
#pragma once
#include <array>
#include <filesystem>
#include <vector>

#include "base/result.h"
#include "base/vec.h"
#include "sky/sky_rows.h"

namespace nullscope {

// The map is evaluated by a cubic B-spline on a coarse grid of every face, and interpolated from there: it has no finer detail.
class MilkyWay {
public:
    // map: linear when loaded, its peak 1; multiplied by brightness. For faces of this size, with a border.
    // Errors: a map that load_image refuses. Cost: 60 ms for faces of 512 and more on one core.
    static Result<MilkyWay> load(const std::filesystem::path& map, const Mat3& world_from_sky, double brightness,
                                 int size, int border);

    // Writes the rows.
    void paint(SkyRows& rows) const;

private:
    using Weights = std::array<double, 4>;
    const float* nodes(int face, std::size_t plane, int row) const;

    int fine_ = 1, side_ = 0;       // texels a cell; nodes a side of a face's grid
    std::vector<Weights> weights_;  // of the nodes about a cell, for each of its texels
    std::vector<float> values_;     // by face, plane, row and column
};

}  // namespace nullscope
