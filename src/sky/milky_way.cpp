// Its loops are to be vectorised: see its compiler options in src/CMakeLists.txt.
#include "sky/milky_way.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <utility>

#include "image/image_file.h"
#include "sky/equirectangular.h"
#include "sky/star_light.h"
#include "sky/wide_lanes.h"

namespace nullscope {
namespace {

constexpr int kMostDustCells = 512;    // a side of a face: 0.11 to 0.22 degrees; the map's pixels are of 0.18
constexpr std::size_t kPixelRun = 64;  // places that are worked out together

// Red, green, blue and one more: what a processor adds at once. (An extension that gcc and clang share; arrays are added one by one.)
using BandLight = float __attribute__((vector_size(16)));

// The one more is what follows in the map, or 0 at its end.
NULLSCOPE_WITHIN_LANES BandLight light_at(const Image<float>& map, int x, int y) {
    const float* pixel = map.at(x, y);
    BandLight light{};
    if (pixel + 4 <= map.data.data() + map.data.size())
        std::memcpy(&light, pixel, sizeof light);
    else
        std::memcpy(&light, pixel, 3 * sizeof *pixel);
    return light;
}

// Places in the map of directions, in single precision: 1e-3 pixels, at half the cost.
struct Places {
    std::array<float, kPixelRun> x, y;

    NULLSCOPE_WITHIN_LANES void fill(const Image<float>& map, Vec3 first, Vec3 step, std::size_t count) {
        const auto fx = static_cast<float>(first.x), fy = static_cast<float>(first.y), fz = static_cast<float>(first.z),
                   sx = static_cast<float>(step.x), sy = static_cast<float>(step.y), sz = static_cast<float>(step.z);
        const auto width = static_cast<float>(map.width), height = static_cast<float>(map.height);
        constexpr float kPi = std::numbers::pi_v<float>;
        for (std::size_t i = 0; i < count; ++i) {
            const auto n = static_cast<float>(static_cast<int>(i));
            const float dx = fx + n * sx, dy = fy + n * sy, dz = fz + n * sz;
            x[i] = (0.5f - fast_atan2(dy, dx) / (2.0f * kPi)) * width;
            y[i] = (0.5f - fast_atan2(dz, std::sqrt(dx * dx + dy * dy)) / kPi) * height;
        }
    }
};

// Bilinear, as the map's pixels are twice as wide as the grid's cells. Columns are periodic, rows clamped.
NULLSCOPE_WITHIN_LANES void sample(const Image<float>& map, float place_x, float place_y, float scale, float* red,
                                   std::size_t plane) {
    const float x = std::max(place_x + 0.5f, 0.0f);  // one more than the pixel's number: a cast is floor
    const float y = std::clamp(place_y - 0.5f, 0.0f, static_cast<float>(map.height - 1));
    const int right = static_cast<int>(x), x1 = right < map.width ? right : 0,
              x0 = right > 0 ? right - 1 : map.width - 1;
    const int y0 = static_cast<int>(y), y1 = std::min(y0 + 1, map.height - 1);
    const float tx = x - static_cast<float>(right), ty = y - static_cast<float>(y0);
    const float below = scale * ty, above = scale - below;
    const float wa = above - above * tx, wb = above * tx, wc = below - below * tx, wd = below * tx;
    const BandLight a = light_at(map, x0, y0), b = light_at(map, x1, y0), c = light_at(map, x0, y1),
                    d = light_at(map, x1, y1);
    const BandLight sum = wa * a + wb * b + wc * c + wd * d;
    red[0] = sum[0], red[plane] = sum[1], red[2 * plane] = sum[2];
}

// Of `count` directions, one step apart, times scale: three planes of `count` numbers.
NULLSCOPE_WIDE_LANES void sample_run(const Image<float>& map, Vec3 first, Vec3 step, std::size_t count, float scale,
                                     float* out) {
    Places places;
    for (std::size_t begin = 0; begin < count; begin += kPixelRun) {
        const std::size_t run = std::min(kPixelRun, count - begin);
        places.fill(map, first + static_cast<double>(begin) * step, step, run);
        for (std::size_t i = 0; i < run; ++i) sample(map, places.x[i], places.y[i], scale, out + begin + i, count);
    }
}

}  // namespace

double radiance_of_s10() {
    constexpr double kSquareDegree = std::numbers::pi * std::numbers::pi / (180.0 * 180.0);
    return star_flux(10.0) / kSquareDegree;
}

Result<MilkyWay> MilkyWay::load(const std::filesystem::path& path, const Mat3& world_from_sky, double brightness,
                                int size, int border) {
    Result<Image<float>> map = load_image(path);
    if (!map) return failed(map.error().message());
    return MilkyWay(std::move(*map), FaceGrid(world_from_sky, size, border, kMostDustCells),
                    brightness * kMapWhite_S10 * radiance_of_s10());
}

void MilkyWay::paint(SkyRows& rows) const {
    const auto scale = static_cast<float>(scale_);
    grid_.paint(rows, [&](Vec3 first, Vec3 step, std::size_t count, float* out) {
        sample_run(map_, first, step, count, scale, out);
    });
}

}  // namespace nullscope
