#include "sky/star_light.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

namespace nullscope {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTexelsPerSigma = 0.6;
constexpr double kCoreReach = 4.0;                   // sigmas; exp(-8) = 0.03 % of the flux would lie outside
constexpr int kBandRows = 32;                        // rows of a face a task owns
constexpr double kCornerAngle = 0.9553166181245093;  // of a face, from its centre: atan(sqrt 2)
// rad; the farthest a light reaches. kCornerAngle + 2 kMaxReach stays below pi/2, where the gnomonic image ends.
constexpr double kMaxReach = 0.3;

// The halo of scattered light that makes bright stars look large: Moffat's profile (1 + (a / s)^2)^-2, s in angle.
constexpr double kHaloNone = 5.5, kHaloFull = 3.5;  // magnitudes between which it sets in
constexpr double kHaloFraction = 0.25;              // of the star's flux: about what an eye scatters near the source
constexpr double kHaloSigmas = 5.12;                // s in sigmas of the core: 10 arc minutes at kReferenceFace
constexpr double kHaloFloor = 1.5e-4;  // radiance at which it is cut, smoothly: half a step of an 8-bit display

struct Light {
    Vec3 direction;           // world, unit
    Vec3 core, halo;          // radiance at the centre
    double sigma = 0.0;       // of the core, rad
    double reach = 0.0;       // rad
    double halo_reach = 0.0;  // rad; 0: none
};

// A light's rectangle of texels in one face, bounds inclusive.
struct Splat {
    std::uint32_t light;
    int x0, x1, y0, y1;
};

double core_profile(const Light& light, double squared_angle) {
    const double q = squared_angle / (light.sigma * light.sigma);
    return q < kCoreReach * kCoreReach ? std::exp(-0.5 * q) : 0.0;
}

double halo_profile(const Light& light, double squared_angle) {
    const double reach = light.halo_reach, scale = kHaloSigmas * light.sigma;
    const double window = 1.0 - squared_angle / (reach * reach);
    if (!(window > 0.0)) return 0.0;
    const double moffat = 1.0 + squared_angle / (scale * scale);
    return window * window / (moffat * moffat);
}

std::vector<Vec3> colour_table() {
    std::vector<Vec3> table(kColourCodes);
    tbb::parallel_for(0, kColourCodes, [&](int i) { table[static_cast<std::size_t>(i)] = star_colour(b_minus_v(i)); });
    return table;
}

// The texels of a face that a light can reach, from the gnomonic image of its cap: the cap's farthest point from the
// face's centre bounds the stretch.
std::optional<Splat> splat_on(const Light& light, std::uint32_t index, int face, int size) {
    const Vec3 centre = cube_direction(face, 0.5, 0.5);
    const Vec3 right = 0.5 * (cube_direction(face, 1.0, 0.5) - cube_direction(face, 0.0, 0.5));
    const Vec3 down = 0.5 * (cube_direction(face, 0.5, 1.0) - cube_direction(face, 0.5, 0.0));
    const double depth = dot(light.direction, centre);
    if (depth <= std::cos(kCornerAngle + light.reach)) return std::nullopt;
    const double s = dot(light.direction, right) / depth, t = dot(light.direction, down) / depth;
    const double off_axis = std::atan(std::hypot(s, t));
    const double half = std::tan(off_axis + light.reach) - std::tan(off_axis);
    const auto texel = [&](double plane) { return static_cast<int>(std::floor(0.5 * (plane + 1.0) * size)); };
    const Splat splat{index, std::max(texel(s - half), 0), std::min(texel(s + half), size - 1),
                      std::max(texel(t - half), 0), std::min(texel(t + half), size - 1)};
    if (splat.x0 > splat.x1 || splat.y0 > splat.y1) return std::nullopt;
    return splat;
}

// Calls visit(x, y, squared angle to the light, solid angle of the texel) for the splat's texels in rows [row0, row1).
template <class Visit>
void for_each_texel(int face, int size, const Splat& splat, Vec3 light, int row0, int row1, const Visit& visit) {
    const Vec3 along = cube_direction(face, 1.0, 0.0) - cube_direction(face, 0.0, 0.0);
    const double texel = 4.0 / (static_cast<double>(size) * size);
    for (int y = std::max(splat.y0, row0); y <= std::min(splat.y1, row1 - 1); ++y) {
        const Vec3 left = cube_direction(face, 0.0, (y + 0.5) / size);
        for (int x = splat.x0; x <= splat.x1; ++x) {
            const Vec3 plane = left + ((x + 0.5) / size) * along;
            const double distance = std::sqrt(dot(plane, plane));
            const Vec3 chord = plane / distance - light;  // its square is the angle's to 0.8 % at kMaxReach
            visit(x, y, dot(chord, chord), texel / (distance * distance * distance));
        }
    }
}

double halo_reach(double flux, double scale) {
    const double centre = flux / (kPi * scale * scale);  // of the profile without a cut
    const double ratio = std::sqrt(std::max(centre / kHaloFloor, 1.0)) - 1.0;
    return std::clamp(scale * std::sqrt(ratio), 2.0 * scale, std::max(2.0 * scale, kMaxReach));
}

// The profiles are normalised by their sums over texels, so that the flux is exact wherever the star lies.
Light make_light(const Star& star, Vec3 colour, Vec3 direction, double brightness, int size) {
    const double flux = brightness * star_flux(star.magnitude);
    Light light{direction, {}, {}, core_sigma(size), kCoreReach * core_sigma(size), 0.0};
    double fraction = kHaloFraction * std::clamp((kHaloNone - star.magnitude) / (kHaloNone - kHaloFull), 0.0, 1.0);
    const double scale = kHaloSigmas * light.sigma;
    if (2.0 * scale > kMaxReach) fraction = 0.0;  // a face so coarse (below 64 texels) shows no halo
    if (fraction > 0.0) light.halo_reach = halo_reach(fraction * flux, scale);
    light.reach = std::max(light.reach, light.halo_reach);
    double core = 0.0, halo = 0.0;
    for (int face = 0; face < 6; ++face)
        if (const auto splat = splat_on(light, 0, face, size))
            for_each_texel(face, size, *splat, direction, 0, size, [&](int, int, double squared, double solid_angle) {
                core += solid_angle * core_profile(light, squared);
                if (fraction > 0.0) halo += solid_angle * halo_profile(light, squared);
            });
    light.core = ((1.0 - fraction) * flux / core) * colour;
    if (fraction > 0.0) light.halo = (fraction * flux / halo) * colour;
    return light;
}

void draw(Image<float>& image, int face, const Splat& splat, const Light& light, int row0, int row1) {
    for_each_texel(face, image.width, splat, light.direction, row0, row1, [&](int x, int y, double squared, double) {
        Vec3 radiance = core_profile(light, squared) * light.core;
        if (light.halo_reach > 0.0) radiance = radiance + halo_profile(light, squared) * light.halo;
        float* out = image.at(x, y);
        out[0] += static_cast<float>(radiance.x);
        out[1] += static_cast<float>(radiance.y);
        out[2] += static_cast<float>(radiance.z);
    });
}

}  // namespace

double core_sigma(int face_size) { return kTexelsPerSigma * 2.0 / std::min(face_size, kReferenceFace); }

double star_flux(double magnitude) {
    const double reference = core_sigma(kReferenceFace);
    return kPeakOfMagnitude5 * 2.0 * kPi * reference * reference * std::pow(10.0, -0.4 * (magnitude - 5.0));
}

void add_stars(SkyCube& sky, const std::vector<Star>& stars, const Mat3& world_from_sky, double brightness) {
    const std::vector<Vec3> colours = colour_table();
    std::vector<Light> lights(stars.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, stars.size()), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
            lights[i] = make_light(stars[i], colours[stars[i].colour_code], world_from_sky * stars[i].direction,
                                   brightness, sky.size);
    });
    // Every band of rows draws its splats in the catalogue's order, so that sums do not depend on scheduling.
    const int bands = (sky.size + kBandRows - 1) / kBandRows, tasks = 6 * bands;
    std::vector<std::vector<Splat>> splats(static_cast<std::size_t>(tasks));
    tbb::parallel_for(0, 6, [&](int face) {
        for (std::size_t i = 0; i < lights.size(); ++i)
            if (const auto splat = splat_on(lights[i], static_cast<std::uint32_t>(i), face, sky.size))
                for (int band = splat->y0 / kBandRows; band <= splat->y1 / kBandRows; ++band)
                    splats[static_cast<std::size_t>(face * bands + band)].push_back(*splat);
    });
    tbb::parallel_for(0, tasks, [&](int task) {
        const int face = task / bands, row0 = task % bands * kBandRows;
        Image<float>& image = sky.faces[static_cast<std::size_t>(face)];
        for (const Splat& splat : splats[static_cast<std::size_t>(task)])
            draw(image, face, splat, lights[splat.light], row0, row0 + kBandRows);
    });
}

}  // namespace nullscope
