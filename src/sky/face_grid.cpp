// Its loops are to be vectorised: see its compiler options in src/CMakeLists.txt.
#include "sky/face_grid.h"

#include <algorithm>

#include "sky/cube.h"

namespace nullscope {
namespace {

using Weights = std::array<double, 4>;

// Of samples -1, 0, 1, 2 at t in [0, 1].
Weights catmull_rom(double t) {
    const double s = 1.0 - t;
    return {-0.5 * t * s * s, 1.0 - 2.5 * t * t + 1.5 * t * t * t, 1.0 - 2.5 * s * s + 1.5 * s * s * s,
            -0.5 * s * t * t};
}

// Texels of a row from the nodes about it, kFine a cell.
template <int kFine>
void interpolate(const float* nodes, int cells, const std::vector<Weights>& weights, float* out) {
    float w[4][kFine];
    for (std::size_t i = 0; i < kFine; ++i)
        for (std::size_t k = 0; k < 4; ++k) w[k][i] = static_cast<float>(weights[i][k]);
    for (int cell = 0; cell < cells; ++cell, out += kFine) {
        const float* p = nodes + cell;
        for (std::size_t i = 0; i < kFine; ++i) {
            const float value = w[0][i] * p[0] + w[1][i] * p[1] + w[2][i] * p[2] + w[3][i] * p[3];
            out[i] = value > 0.0f ? value : 0.0f;
        }
    }
}

}  // namespace

FaceGrid::FaceGrid(const Mat3& world_from_sky, int size, int border, int most_cells)
    : cells_(std::min(size, most_cells)),
      fine_(size / cells_),
      before_(1 + border / fine_),
      sky_from_world_(transposed(world_from_sky)) {
    for (int i = 0; i < fine_; ++i) weights_.push_back(catmull_rom((i + 0.5) / fine_));
}

void FaceGrid::paint(SkyRows& rows, const NodeLight& light) const {
    const auto side = static_cast<std::size_t>(cells_) + 1 + 2 * static_cast<std::size_t>(before_);
    const int first = (rows.first + rows.border) / fine_,
              last = (rows.first + rows.count - 1 + rows.border) / fine_ + 3;
    const FaceAxes axes = face_axes(rows.face);
    const Vec3 along = sky_from_world_ * axes.right;
    rows.nodes.resize((static_cast<std::size_t>(last - first + 1) * 3 + 1) * side);
    for (int y = first; y <= last; ++y) {
        const double down = 2.0 * (y - before_) / cells_ - 1.0, left = -2.0 * before_ / cells_ - 1.0;
        light(sky_from_world_ * (axes.middle + down * axes.down) + left * along, 2.0 / cells_ * along, side,
              rows.nodes.data() + static_cast<std::size_t>(y - first) * 3 * side);
    }
    float* column = rows.nodes.data() + rows.nodes.size() - side;
    const int cells = rows.width() / fine_;
    for (int y = rows.first; y < rows.first + rows.count; ++y) {
        const int from_top = y + rows.border;
        const Weights& wy = weights_[static_cast<std::size_t>(from_top % fine_)];
        const float w[4] = {static_cast<float>(wy[0]), static_cast<float>(wy[1]), static_cast<float>(wy[2]),
                            static_cast<float>(wy[3])};
        for (std::size_t plane = 0; plane < 3; ++plane) {
            const float* p =
                rows.nodes.data() + (static_cast<std::size_t>(from_top / fine_ - first) * 3 + plane) * side;
            for (std::size_t i = 0; i < side; ++i)
                column[i] = w[0] * p[i] + w[1] * p[i + 3 * side] + w[2] * p[i + 6 * side] + w[3] * p[i + 9 * side];
            float* out = rows.row(plane, y);
            switch (fine_) {
                case 1: interpolate<1>(column, cells, weights_, out); break;
                case 2: interpolate<2>(column, cells, weights_, out); break;
                case 4: interpolate<4>(column, cells, weights_, out); break;
                case 8: interpolate<8>(column, cells, weights_, out); break;
                default: interpolate<16>(column, cells, weights_, out); break;  // 8192 of 512 cells
            }
        }
    }
}

}  // namespace nullscope
