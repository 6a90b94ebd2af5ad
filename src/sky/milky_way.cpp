// Its loops are to be vectorised: see its compiler options in src/CMakeLists.txt.
#include "sky/milky_way.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "image/image_file.h"
#include "sky/cube.h"
#include "sky/equirectangular.h"

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

using Light = std::array<float, 4>;  // red, green, blue and nothing: what a processor adds at once

// The map, a Light a pixel.
std::vector<Light> lights_of(const Image<float>& map) {
    std::vector<Light> lights(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
    const float* from = map.data.data();
    for (Light& light : lights) light = {from[0], from[1], from[2], 0.0f}, from += map.channels;
    return lights;
}

// Smooths the map's 8-bit steps and dither as well. Columns are periodic, rows clamped.
Light sample_map(const std::vector<Light>& map, int width, int height, PanoramaPosition p) {
    const double fx = std::floor(p.x - 0.5), fy = std::floor(p.y - 0.5);
    const Weights wx = b_spline(p.x - 0.5 - fx), wy = b_spline(p.y - 0.5 - fy);
    std::array<int, 4> columns{};
    for (int i = 0; i < 4; ++i) {
        const int x = static_cast<int>(fx) + i - 1;
        const bool inside = x >= 0 && x < width;  // a division for each would be half of the cost
        columns[static_cast<std::size_t>(i)] = inside ? x : (x % width + width) % width;
    }
    Light sum{};
    for (int j = 0; j < 4; ++j) {
        const Light* row =
            map.data() + static_cast<std::size_t>(std::clamp(static_cast<int>(fy) + j - 1, 0, height - 1)) *
                             static_cast<std::size_t>(width);
        for (std::size_t i = 0; i < 4; ++i) {
            const auto w = static_cast<float>(wx[i] * wy[static_cast<std::size_t>(j)]);
            for (std::size_t c = 0; c < 4; ++c) sum[c] += w * row[columns[i]][c];
        }
    }
    return sum;
}

// Texels of a row from the nodes about it, kFine a cell. Neighbouring faces agree on a common edge: it does not show.
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

Result<MilkyWay> MilkyWay::load(const std::filesystem::path& path, const Mat3& world_from_sky, double brightness,
                                int size, int border) {
    const Result<Image<float>> map = load_image(path);
    if (!map) return failed(map.error().message());
    MilkyWay way;
    const int cells = std::min(size, kGridSize);
    way.fine_ = size / cells;
    for (int i = 0; i < way.fine_; ++i) way.weights_.push_back(catmull_rom((i + 0.5) / way.fine_));
    const int before = 1 + border / way.fine_;  // nodes on each side beyond the face
    const int side = way.side_ = cells + 1 + 2 * before;
    const std::size_t plane = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
    way.values_.resize(6 * 3 * plane);
    const Mat3 sky_from_world = transposed(world_from_sky);
    const std::vector<Light> lights = lights_of(*map);
    tbb::parallel_for(0, 6 * side, [&](int task) {
        const int face = task / side, y = task % side;
        const FaceAxes axes = face_axes(face);
        const Vec3 left = sky_from_world * (axes.middle + (2.0 * (y - before) / cells - 1.0) * axes.down),
                   along = sky_from_world * axes.right;
        std::vector<PanoramaPosition> places(static_cast<std::size_t>(side));
        for (int x = 0; x < side; ++x)
            places[static_cast<std::size_t>(x)] =
                equirectangular_position(map->width, map->height, left + (2.0 * (x - before) / cells - 1.0) * along);
        float* out = way.values_.data() + 3 * plane * static_cast<std::size_t>(face) +
                     static_cast<std::size_t>(y) * static_cast<std::size_t>(side);
        for (const PanoramaPosition& place : places) {
            const Light light = sample_map(lights, map->width, map->height, place);
            for (std::size_t c = 0; c < 3; ++c) out[c * plane] = static_cast<float>(brightness) * light[c];
            ++out;
        }
    });
    return way;
}

const float* MilkyWay::nodes(int face, std::size_t plane, int row) const {
    const auto side = static_cast<std::size_t>(side_);
    return values_.data() +
           ((static_cast<std::size_t>(face) * 3 + plane) * side + static_cast<std::size_t>(row)) * side;
}

void MilkyWay::paint(SkyRows& rows) const {
    std::vector<float> column(static_cast<std::size_t>(side_));
    const int cells = rows.width() / fine_;
    for (int y = rows.first; y < rows.first + rows.count; ++y) {
        const int from_top = y + rows.border;
        const Weights& wy = weights_[static_cast<std::size_t>(from_top % fine_)];
        for (std::size_t plane = 0; plane < 3; ++plane) {
            std::fill(column.begin(), column.end(), 0.0f);
            for (std::size_t j = 0; j < 4; ++j) {
                const float* source = nodes(rows.face, plane, from_top / fine_ + static_cast<int>(j));
                const auto w = static_cast<float>(wy[j]);
                for (std::size_t i = 0; i < column.size(); ++i) column[i] += w * source[i];
            }
            float* out = rows.row(plane, y);
            switch (fine_) {
                case 1: interpolate<1>(column.data(), cells, weights_, out); break;
                case 2: interpolate<2>(column.data(), cells, weights_, out); break;
                case 4: interpolate<4>(column.data(), cells, weights_, out); break;
                case 8: interpolate<8>(column.data(), cells, weights_, out); break;
                default: interpolate<16>(column.data(), cells, weights_, out); break;  // faces of 8192, the largest
            }
        }
    }
}

}  // namespace nullscope
