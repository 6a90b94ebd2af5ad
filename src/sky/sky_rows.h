// A band of rows of one face of the celestial sphere, while it is painted: linear RGB, a plane each.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace nullscope {

// Rows [first, first + count) of a face of size x size texels and of a border of so many texels about it. Row and column 0 are the
// face's own first: the border's lie before them and from `size` on.
struct SkyRows {
    int face = 0, size = 0, border = 0, first = 0, count = 0;
    std::array<std::vector<float>, 3> planes;
    std::vector<float> nodes;  // scratch of FaceGrid

    int width() const { return size + 2 * border; }
    float* row(std::size_t plane, int y) {
        return planes[plane].data() + static_cast<std::size_t>(y - first) * static_cast<std::size_t>(width());
    }  // its leftmost texel

    std::size_t texels() const { return static_cast<std::size_t>(width()) * static_cast<std::size_t>(count); }
};

}  // namespace nullscope
