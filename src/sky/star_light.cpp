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
constexpr double kCoreReach = 4.0;  // sigmas; exp(-8) = 0.03 % of the flux lies outside
constexpr int kBandRows = 32;       // rows of a face a task owns

// The halo of scattered light that makes bright stars look large: Moffat's profile (1 + (a / s)^2)^-2, s in angle.
constexpr double kHaloLimit = 4.5;      // magnitude; fainter stars' halo would stay below kHaloFloor anyway
constexpr double kHaloFraction = 0.25;  // of the star's flux: about what an eye scatters near the source
constexpr double kHaloScale = 3.0e-3;   // s in rad: 10 arc minutes
constexpr double kHaloFloor = 1.5e-4;   // radiance at which it is cut (smoothly): half a step of an 8-bit display
constexpr double kMaxHaloReach = 0.06;  // rad
constexpr int kHaloSteps = 400;         // of the integral that normalises the cut profile
constexpr double kCornerAngle = 0.9553166181245093;  // of a face, from its centre: atan(sqrt 2)

struct Light {
    Vec3 direction;     // world, unit
    Vec3 core, halo;    // radiance at the centre
    double reach;       // rad
    double halo_reach;  // rad; 0: none
};

// A light's rectangle of texels in one face, bounds inclusive.
struct Splat {
    std::uint32_t light;
    int x0, x1, y0, y1;
};

double halo_profile(double squared_angle, double reach) {
    const double window = 1.0 - squared_angle / (reach * reach);
    if (window <= 0.0) return 0.0;
    const double moffat = 1.0 + squared_angle / (kHaloScale * kHaloScale);
    return window * window / (moffat * moffat);
}

double halo_integral(double reach) {
    const double step = reach / kHaloSteps;
    double sum = 0.0;
    for (int i = 0; i < kHaloSteps; ++i) {
        const double angle = (i + 0.5) * step;
        sum += halo_profile(angle * angle, reach) * 2.0 * kPi * angle * step;
    }
    return sum;
}

std::vector<Vec3> colour_table() {
    std::vector<Vec3> table(kColourCodes);
    tbb::parallel_for(0, kColourCodes, [&](int i) { table[static_cast<std::size_t>(i)] = star_colour(b_minus_v(i)); });
    return table;
}

Light make_light(const Star& star, const Vec3& colour, const Mat3& world_from_sky, double brightness, double sigma) {
    const double reference = core_sigma(kReferenceFace);
    const double flux = brightness * kPeakOfMagnitude5 * 2.0 * kPi * reference * reference *
                        std::pow(10.0, -0.4 * (star.magnitude - 5.0));
    Light light{world_from_sky * star.direction, {}, {}, kCoreReach * sigma, 0.0};
    double core_flux = flux;
    if (star.magnitude < kHaloLimit) {
        const double unlimited = kHaloFraction * flux / (kPi * kHaloScale * kHaloScale);
        const double ratio = std::sqrt(std::max(unlimited / kHaloFloor, 1.0)) - 1.0;
        light.halo_reach = std::clamp(kHaloScale * std::sqrt(ratio), 2.0 * kHaloScale, kMaxHaloReach);
        light.halo = (kHaloFraction * flux / halo_integral(light.halo_reach)) * colour;
        light.reach = std::max(light.reach, light.halo_reach);
        core_flux = (1.0 - kHaloFraction) * flux;
    }
    light.core = (core_flux / (2.0 * kPi * sigma * sigma)) * colour;
    return light;
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

void draw(Image<float>& image, int face, const Splat& splat, const Light& light, int row0, int row1, double sigma) {
    const double inverse = 1.0 / (2.0 * sigma * sigma);
    const double core_limit = kCoreReach * kCoreReach * sigma * sigma;
    const Vec3 du = cube_direction(face, 1.0, 0.0) - cube_direction(face, 0.0, 0.0);
    for (int y = std::max(splat.y0, row0); y <= std::min(splat.y1, row1 - 1); ++y) {
        const Vec3 left = cube_direction(face, 0.0, (y + 0.5) / image.height);
        float* out = image.at(splat.x0, y);
        for (int x = splat.x0; x <= splat.x1; ++x, out += 3) {
            const Vec3 plane = left + ((x + 0.5) / image.width) * du;
            const Vec3 chord = plane / std::sqrt(dot(plane, plane)) - light.direction;
            const double squared = dot(chord, chord);  // of the angle: the two differ by 1e-4 at kMaxHaloReach
            Vec3 radiance{};
            if (squared < core_limit) radiance = std::exp(-squared * inverse) * light.core;
            if (light.halo_reach > 0.0) radiance = radiance + halo_profile(squared, light.halo_reach) * light.halo;
            out[0] += static_cast<float>(radiance.x);
            out[1] += static_cast<float>(radiance.y);
            out[2] += static_cast<float>(radiance.z);
        }
    }
}

}  // namespace

double core_sigma(int face_size) { return kTexelsPerSigma * 2.0 / std::min(face_size, kReferenceFace); }

void add_stars(SkyCube& sky, const std::vector<Star>& stars, const Mat3& world_from_sky, double brightness) {
    const double sigma = core_sigma(sky.size);
    const std::vector<Vec3> colours = colour_table();
    std::vector<Light> lights(stars.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, stars.size()), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
            lights[i] = make_light(stars[i], colours[stars[i].colour_code], world_from_sky, brightness, sigma);
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
            draw(image, face, splat, lights[splat.light], row0, row0 + kBandRows, sigma);
    });
}

}  // namespace nullscope
