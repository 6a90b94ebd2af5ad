#include "sky/panorama.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/large_image.h"

namespace nullscope {
namespace {

constexpr double kPi = std::numbers::pi;
// A bilinear sample covers two pixels, so samples this far apart leave no gap between them.
constexpr double kPixelsPerSample = 1.5;

// Arctangent of t in [0, 1] by Abramowitz & Stegun 4.4.49. Error below 2e-8 rad: 5e-5 pixels of a 16384-column image.
constexpr double kArctangent[] = {1.0,           -0.3333314528, 0.1999355085,  -0.1420889944, 0.1065626393,
                                  -0.0752896400, 0.0429096138,  -0.0161657367, 0.0028662257};

// std::atan2 at a third of its cost; 0 for (0, 0).
double fast_atan2(double y, double x) {
    const double ax = std::fabs(x), ay = std::fabs(y), larger = std::max(ax, ay);
    if (!(larger > 0.0)) return 0.0;
    const double t = std::min(ax, ay) / larger, q = t * t;
    double angle = 0.0;
    for (int i = 8; i >= 0; --i) angle = angle * q + kArctangent[i];
    angle *= t;
    if (ay > ax) angle = 0.5 * kPi - angle;
    if (x < 0.0) angle = kPi - angle;
    return std::copysign(angle, y);
}

double azimuth(Vec3 d) { return fast_atan2(d.y, d.x); }
double latitude(Vec3 d) { return fast_atan2(d.z, std::sqrt(d.x * d.x + d.y * d.y)); }

// Columns are periodic or clamped, rows clamped.
Vec3 bilinear(const Image<float>& image, double x, double y, bool periodic) {
    const double left = x + 0.5, above = y + 0.5;  // >= 0, so that a cast is floor
    const int fx = static_cast<int>(left) - 1, fy = static_cast<int>(above) - 1;
    const double tx = x - 0.5 - fx, ty = y - 0.5 - fy;
    const auto column = [&](int i) {
        if (periodic) return i < 0 ? i + image.width : i >= image.width ? i - image.width : i;
        return std::clamp(i, 0, image.width - 1);
    };
    const auto row = [&](int i) { return std::clamp(i, 0, image.height - 1); };
    const int x0 = column(fx), x1 = column(fx + 1);
    const int y0 = row(fy), y1 = row(fy + 1);
    const float *a = image.at(x0, y0), *b = image.at(x1, y0), *c = image.at(x0, y1), *d = image.at(x1, y1);
    const double wa = (1 - tx) * (1 - ty), wb = tx * (1 - ty), wc = (1 - tx) * ty, wd = tx * ty;
    return {wa * a[0] + wb * b[0] + wc * c[0] + wd * d[0], wa * a[1] + wb * b[1] + wc * c[1] + wd * d[1],
            wa * a[2] + wb * b[2] + wc * c[2] + wd * d[2]};
}

// Fills every face: sample(sky direction, any length) -> radiance, averaged over n x n samples a texel.
template <class Sample>
void fill(SkyCube& sky, const Mat3& world_from_sky, int n, double brightness, const Sample& sample) {
    const Mat3 sky_from_world = transposed(world_from_sky);
    const double step = 1.0 / (static_cast<double>(sky.size) * n);
    const double weight = brightness / (static_cast<double>(n) * n);
    tbb::parallel_for(0, 6 * sky.size, [&](int task) {
        const int face = task / sky.size, y = task % sky.size;
        float* out = sky.faces[static_cast<std::size_t>(face)].at(0, y);
        for (int x = 0; x < sky.size; ++x, out += 3) {
            Vec3 sum{};
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i)
                    sum = sum + sample(sky_from_world *
                                       cube_direction(face, (x * n + i + 0.5) * step, (y * n + j + 0.5) * step));
            out[0] = static_cast<float>(weight * sum.x);
            out[1] = static_cast<float>(weight * sum.y);
            out[2] = static_cast<float>(weight * sum.z);
        }
    });
}

int samples_per_texel(double pixels_per_radian, int face_size) {
    return std::max(1, static_cast<int>(std::ceil(pixels_per_radian * 2.0 / face_size / kPixelsPerSample)));
}

// Images are read no larger than this: 4 columns a texel along the faces' equator, where 3.14 lie in the middle of a face and one at
// its edge is 2 times as fine; never less than 8192, so that only the largest are touched.
Result<Image<float>> load_for(SkyCube& sky, const std::filesystem::path& path) {
    constexpr int kLeastSide = 8192, kColumnsPerTexel = 4;
    const int side = std::max(kLeastSide, kColumnsPerTexel * sky.size);
    auto fitted = load_fitted_image(path, {.max_side = side});
    if (!fitted) return fitted.error();
    if (fitted->reduced())
        sky.notes.push_back(reduction_words(path, *fitted, fmt::format("the sky's faces are of {} px", sky.size)));
    return std::move(fitted->image);
}

Status draw_equirectangular(SkyCube& sky, const SkySpec& spec, const Mat3& world_from_sky) {
    const Result<Image<float>> image = load_for(sky, spec.image);
    if (!image) return image.error();
    const double density = std::max(image->width / (2.0 * kPi), image->height / kPi);
    fill(sky, world_from_sky, samples_per_texel(density, sky.size), spec.brightness, [&](Vec3 d) {
        const PanoramaPosition p = equirectangular_position(image->width, image->height, d);
        return bilinear(*image, p.x, p.y, true);
    });
    return Done{};
}

// Seen from inside and upright, with the band's middle (azimuth 0) in front: the north cap joins above the band with
// azimuth 0 at its lower edge, the south cap below it with azimuth 0 at its upper edge; azimuth pi/2 is to the left in
// all three.
Vec3 sample_cap(const Image<float>& image, double side, double phi, double fraction) {
    const double radius = 0.5 * std::min(image.width, image.height);
    const double r = std::min(fraction * radius, radius - 0.5);  // the corners outside of the circle are not sky
    const double x = 0.5 * image.width - r * std::sin(phi);
    const double y = 0.5 * image.height + side * r * std::cos(phi);
    return bilinear(image, x, y, false);
}

Status draw_band_and_caps(SkyCube& sky, const SkySpec& spec, const Mat3& world_from_sky) {
    const double limit = spec.band_latitude;
    if (!(limit > 0.0 && limit < 0.5 * kPi))
        return bad_input(fmt::format("sky: band latitude {} is outside (0, pi/2)", limit));
    const Result<Image<float>> band = load_for(sky, spec.image);
    if (!band) return band.error();
    const Result<Image<float>> north = load_for(sky, spec.north_cap);
    if (!north) return north.error();
    const Result<Image<float>> south = load_for(sky, spec.south_cap);
    if (!south) return south.error();
    const double cap_angle = 0.5 * kPi - limit;
    const auto cap_density = [&](const Image<float>& cap) { return 0.5 * std::min(cap.width, cap.height) / cap_angle; };
    const double density =
        std::max({band->width / (2.0 * kPi), band->height / (2.0 * limit), cap_density(*north), cap_density(*south)});
    fill(sky, world_from_sky, samples_per_texel(density, sky.size), spec.brightness, [&](Vec3 d) {
        const double phi = azimuth(d), beta = latitude(d);
        if (beta > limit) return sample_cap(*north, 1.0, phi, (0.5 * kPi - beta) / cap_angle);
        if (beta < -limit) return sample_cap(*south, -1.0, phi, (0.5 * kPi + beta) / cap_angle);
        const double y = 0.5 * (1.0 - beta / limit) * band->height;
        return bilinear(*band, (0.5 - phi / (2.0 * kPi)) * band->width, y, true);
    });
    return Done{};
}

}  // namespace

PanoramaPosition equirectangular_position(int width, int height, Vec3 direction) {
    return {(0.5 - azimuth(direction) / (2.0 * kPi)) * width, (0.5 - latitude(direction) / kPi) * height};
}

Status draw_image(SkyCube& sky, const SkySpec& spec, const Mat3& world_from_sky) {
    return spec.mapping == SkyMapping::kEquirectangular ? draw_equirectangular(sky, spec, world_from_sky)
                                                        : draw_band_and_caps(sky, spec, world_from_sky);
}

}  // namespace nullscope
