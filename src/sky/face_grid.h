// Smooth light on the faces of a cube map: found on a grid coarser than the texels, and interpolated by cubics from there.
#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "base/vec.h"
#include "sky/sky_rows.h"

namespace nullscope {

class FaceGrid {
public:
    // Faces of this size, with a border; a grid of at most so many cells a side, a power of two as the size is.
    FaceGrid(const Mat3& world_from_sky, int size, int border, int most_cells);

    // The light of `count` directions (any length; the sky's axes) from `first`, each `step` farther: `count` floats of red, then green and blue.
    using NodeLight = std::function<void(Vec3 first, Vec3 step, std::size_t count, float* out)>;

    // Writes the rows; what falls below 0 between nodes becomes 0. Faces agree on their common edge, as directions there are the same.
    void paint(SkyRows& rows, const NodeLight& light) const;

private:
    using Weights = std::array<double, 4>;

    int cells_, fine_, before_;     // a side of a face; texels a cell along it; nodes on each side beyond the face
    std::vector<Weights> weights_;  // of the nodes about a cell, for each of its texels
    Mat3 sky_from_world_;
};

}  // namespace nullscope
