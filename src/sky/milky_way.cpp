// The Milky Way: the map is evaluated on a coarse grid of every face and interpolated; it has no finer detail.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/image_file.h"
#include "sky/panorama.h"

namespace nullscope {
namespace {

constexpr int kGridSize = 512;  // cells a side: 0.18 degrees at most, half a pixel of the map that ships

using Weights = std::array<double, 4>;

// Of samples -1, 0, 1, 2 at t in [0, 1].
Weights b_spline(double t) {
    const double s = 1.0 - t;
    return {s * s * s / 6.0, (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0, (4.0 - 6.0 * s * s + 3.0 * s * s * s) / 6.0,
            t * t * t / 6.0};
}

Weights catmull_rom(double t) {
    const double s = 1.0 - t;
    return {-0.5 * t * s * s, 1.0 - 2.5 * t * t + 1.5 * t * t * t, 1.0 - 2.5 * s * s + 1.5 * s * s * s,
            -0.5 * s * t * t};
}

// Smooths the map's 8-bit steps and dither as well. Columns are periodic, rows clamped.
Vec3 sample_map(const Image<float>& map, Vec3 direction) {
    const PanoramaPosition p = equirectangular_position(map.width, map.height, direction);
    const double fx = std::floor(p.x - 0.5), fy = std::floor(p.y - 0.5);
    const Weights wx = b_spline(p.x - 0.5 - fx), wy = b_spline(p.y - 0.5 - fy);
    Vec3 sum{};
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            const int x = (static_cast<int>(fx) + i - 1 + 2 * map.width) % map.width;
            const int y = std::clamp(static_cast<int>(fy) + j - 1, 0, map.height - 1);
            const float* c = map.at(x, y);
            const double w = wx[static_cast<std::size_t>(i)] * wy[static_cast<std::size_t>(j)];
            sum = sum + w * Vec3{c[0], c[1], c[2]};
        }
    return sum;
}

// Values at the corners of a face's cells and one row beyond each edge: neighbours agree on a common edge, so that it
// does not show.
class Grid {
public:
    Grid(const Image<float>& map, const Mat3& sky_from_world, int face, int cells, double brightness)
        : nodes_(cells + 3), values_(static_cast<std::size_t>(3 * nodes_) * static_cast<std::size_t>(nodes_)) {
        tbb::parallel_for(0, nodes_, [&](int y) {
            float* out = row(y);
            for (int x = 0; x < nodes_; ++x) {
                const Vec3 direction = cube_direction(face, (x - 1.0) / cells, (y - 1.0) / cells);
                const Vec3 value = brightness * sample_map(map, sky_from_world * direction);
                *out++ = static_cast<float>(value.x);
                *out++ = static_cast<float>(value.y);
                *out++ = static_cast<float>(value.z);
            }
        });
    }

    // A row of texels, `fine` of them a cell.
    void interpolate(int y, int fine, const std::vector<Weights>& weights, float* out) const {
        std::vector<float> column(static_cast<std::size_t>(3 * nodes_));
        const Weights& wy = weights[static_cast<std::size_t>(y % fine)];
        for (int j = 0; j < 4; ++j) {
            const float* source = row(y / fine + j);
            const auto w = static_cast<float>(wy[static_cast<std::size_t>(j)]);
            for (std::size_t i = 0; i < column.size(); ++i) column[i] += w * source[i];
        }
        for (int cell = 0; cell < nodes_ - 3; ++cell)
            for (int i = 0; i < fine; ++i)
                for (int c = 0; c < 3; ++c) {
                    const float* p = column.data() + 3 * cell + c;
                    const Weights& w = weights[static_cast<std::size_t>(i)];
                    const double value = w[0] * p[0] + w[1] * p[3] + w[2] * p[6] + w[3] * p[9];
                    *out++ = static_cast<float>(std::max(value, 0.0));
                }
    }

private:
    float* row(int y) { return values_.data() + static_cast<std::size_t>(3 * nodes_) * static_cast<std::size_t>(y); }
    const float* row(int y) const { return const_cast<Grid*>(this)->row(y); }
    int nodes_;
    std::vector<float> values_;
};

}  // namespace

Status draw_milky_way(SkyCube& sky, const std::filesystem::path& path, const Mat3& world_from_sky, double brightness) {
    const Result<Image<float>> map = load_image(path);
    if (!map) return failed(map.error().message);
    const int cells = std::min(sky.size, kGridSize), fine = sky.size / cells;
    std::vector<Weights> weights;
    weights.reserve(static_cast<std::size_t>(fine));
    for (int i = 0; i < fine; ++i) weights.push_back(catmull_rom((i + 0.5) / fine));
    const Mat3 sky_from_world = transposed(world_from_sky);
    for (int face = 0; face < 6; ++face) {
        const Grid grid(*map, sky_from_world, face, cells, brightness);
        Image<float>& image = sky.faces[static_cast<std::size_t>(face)];
        tbb::parallel_for(0, sky.size, [&](int y) { grid.interpolate(y, fine, weights, image.at(0, y)); });
    }
    return Done{};
}

}  // namespace nullscope
