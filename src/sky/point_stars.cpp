#include "sky/point_stars.h"

#include <cmath>

#include "sky/sky.h"
#include "sky/star_catalogue.h"
#include "sky/star_light.h"

namespace nullscope {
namespace {

constexpr double kSun_K = 5772.0;

// Points of equal solid angle on a spiral that turns by the golden angle.
Vec3 spiral_place(int i, int count) {
    const double z = 1.0 - (2.0 * i + 1.0) / count, rho = std::sqrt((1.0 - z) * (1.0 + z)),
                 turn = 2.399963229728653 * i;
    return {rho * std::cos(turn), rho * std::sin(turn), z};
}

}  // namespace

Result<std::vector<PointStar>> point_stars(const SkySpec& spec, const std::filesystem::path& assets) {
    std::vector<PointStar> stars;
    if (spec.kind != SkyKind::kPoints) return stars;
    const Mat3 world_from_sky = sky_rotation(spec);
    if (spec.uniform_stars > 0) {
        const double flux = spec.brightness * star_flux(spec.magnitude_limit);
        for (int i = 0; i < spec.uniform_stars; ++i)
            stars.push_back({world_from_sky * spiral_place(i, spec.uniform_stars), flux, kSun_K});
        return stars;
    }
    TRY(catalogue, load_stars(spec.catalogue, assets));
    for (const Star& star : *catalogue) {
        if (star.magnitude > spec.magnitude_limit) break;
        stars.push_back({world_from_sky * star.direction, spec.brightness * star_flux(star.magnitude),
                         star_temperature(b_minus_v(static_cast<int>(star.colour_code)))});
    }
    return stars;
}

}  // namespace nullscope
