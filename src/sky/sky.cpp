#include "sky/sky.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <bit>
#include <cmath>

#include "sky/panorama.h"
#include "sky/star_catalogue.h"
#include "sky/star_light.h"

namespace nullscope {
namespace {

constexpr int kMinFaceSize = 16, kMaxFaceSize = 8192;

// Radiance of the Milky Way's brightest cloud, linear: sRGB 0.38, below a star of V = 5 as under a dark sky.
constexpr double kMilkyWayPeak = 0.12;

Status draw_haze(SkyCube& sky, const SkySpec& spec, const std::filesystem::path& assets, const Mat3& world_from_sky) {
    return draw_milky_way(sky, assets / "sky" / "milky-way.png", world_from_sky, spec.brightness * kMilkyWayPeak);
}

Status draw_stars(SkyCube& sky, const SkySpec& spec, const std::filesystem::path& assets, const Mat3& world_from_sky) {
    const Result<std::vector<Star>> stars = load_stars(assets / "sky" / "stars.bin");
    if (!stars) return stars.error();
    if (Status drawn = draw_haze(sky, spec, assets, world_from_sky); !drawn) return drawn;
    add_stars(sky, *stars, world_from_sky, spec.brightness);
    return Done{};
}

}  // namespace

Mat3 sky_rotation(const SkySpec& spec) {
    const double cy = std::cos(spec.yaw), sy = std::sin(spec.yaw), ct = std::cos(spec.tilt), st = std::sin(spec.tilt);
    return Mat3{{cy, sy, 0}, {-sy, cy, 0}, {0, 0, 1}} * Mat3{{1, 0, 0}, {0, ct, st}, {0, -st, ct}};
}

Result<SkyCube> build_sky(const SkySpec& spec, const std::filesystem::path& assets, int face_size) {
    if (face_size < kMinFaceSize || face_size > kMaxFaceSize || !std::has_single_bit(static_cast<unsigned>(face_size)))
        return bad_input(
            fmt::format("sky: face size {} is not a power of two in [{}, {}]", face_size, kMinFaceSize, kMaxFaceSize));
    SkyCube sky;
    sky.size = face_size;
    tbb::parallel_for(std::size_t{0}, sky.faces.size(),
                      [&](std::size_t face) { sky.faces[face] = Image<float>(face_size, face_size, 3); });
    const Mat3 world_from_sky = sky_rotation(spec);
    Status drawn = Done{};
    if (spec.kind == SkyKind::kStars) drawn = draw_stars(sky, spec, assets, world_from_sky);
    if (spec.kind == SkyKind::kPoints) drawn = draw_haze(sky, spec, assets, world_from_sky);
    if (spec.kind == SkyKind::kImage) drawn = draw_image(sky, spec, world_from_sky);
    if (!drawn) return drawn.error();
    return sky;
}

}  // namespace nullscope
