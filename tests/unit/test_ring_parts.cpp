// A picture in parts: places along a curve and a grid have all of a light together, of rings thinner than a step too; what half of the places would change.
#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <vector>

#include "scene/pixel_mesh.h"
#include "scene/projection.h"
#include "telescope/ring_chart.h"
#include "telescope/sky_sum.h"

namespace {

using namespace nullscope;

using Shining = std::function<double(double right, double up)>;

ClosedCurve curve_of(const std::function<double(double)>& radius, int count) {
    ClosedCurve curve{{0.3, -0.2}, {}};
    for (int i = 0; i < count; ++i) curve.radius.push_back(radius(2 * M_PI * i / count));
    return curve;
}

LightPoints band_of(const RingChart& chart, const Shining& light) {
    LightPoints points(1);
    for (int angle = 0; angle < chart.around(); ++angle)
        for (int number = 0; number < chart.across(); ++number) {
            const RingChart::Place place = chart.place(number, angle);
            points.add(-place.at[0], place.at[1], {place.window * place.area * light(place.at[0], place.at[1])},
                       (number + angle) % 2 != 0);
        }
    return points;
}

// side: of the picture, in which are so many pixels.
PictureVisibility grid_of(const RingChart& chart, const Shining& light, double side, int pixels) {
    SkyPicture picture{Image<double>(pixels, pixels, 1), side / pixels};
    const double p = picture.pixel;
    for (int y = 0; y < pixels; ++y)
        for (int x = 0; x < pixels; ++x) {
            const double right = (x + 0.5) * p - 0.5 * side, up = 0.5 * side - (y + 0.5) * p;
            picture.flux.at(x, y)[0] = p * p * light(right, up) * (1 - chart.window(right, up));
        }
    return {picture, PixelShape::kPoint};
}

double oval(double angle) { return 5.0 + 0.7 * std::cos(angle) + 0.2 * std::sin(2 * angle); }

TEST_CASE("ring parts: a wide light is the sum of what grid and band have of it") {
    const RingChart chart(curve_of(oval, 256), 256);
    constexpr double kWide = 2.5;
    const Shining light = [](double x, double y) { return std::exp(-0.5 * (x * x + y * y) / (kWide * kWide)); };
    const SkySum sum{grid_of(chart, light, 32, 160), band_of(chart, light)};
    const double whole = 2 * M_PI * kWide * kWide;
    CHECK(sum.band->whole() > 0.1 * whole);
    CHECK(sum.band->whole() < 0.9 * whole);
    for (const Baseline b : {Baseline{0, 0}, {0.03, 0.02}, {-0.1, 0.05}, {0.3, 0.1}, {1, -1}}) {
        const double meant = whole * std::exp(-2 * std::pow(M_PI * kWide, 2) * (b.u * b.u + b.v * b.v));
        CHECK(std::abs(sum.at(b)[0] - meant) < 2e-5 * whole);
    }
}

TEST_CASE("ring parts: rings e^-3 as wide and as near as the one before are as exact") {
    const RingChart chart(curve_of([](double) { return 5.0; }, 512), 512);
    for (const double away : {0.3, 0.015, 7e-4, -0.02}) {
        const double sigma = 0.02 * std::fabs(away), radius = 5 + away;  // a step is twice that
        const Shining light = [&](double x, double y) {
            return std::exp(-0.5 * std::pow((std::hypot(x - 0.3, y + 0.2) - radius) / sigma, 2));
        };
        const LightPoints band = band_of(chart, light);
        const double whole = 2 * M_PI * radius * sigma * std::sqrt(2 * M_PI);
        for (const double u : {0.0, 0.1, 1.0, 1.9}) {
            const std::complex<double> place = std::polar(1.0, -2 * M_PI * u * 0.3);  // east is left
            const double meant = whole * std::cyl_bessel_j(0.0, 2 * M_PI * u * radius);
            const double blur = std::exp(-2 * std::pow(M_PI * sigma * u, 2));
            CHECK_MESSAGE(std::abs(band.at({u, 0}).all[0] - meant * blur * place) < 5e-4 * whole, away, ", ", u);
        }
    }
}

TEST_CASE("ring parts: places are summed to 1e-9, and halves are told apart") {
    LightPoints points(4);
    std::complex<double> even, odd;
    const Baseline b{3.7e3, -1.9e3};
    for (int i = 0; i < 150; ++i) {
        const double l = std::sin(i * 1.7), m = std::cos(i * 2.3), light = 1 + 0.3 * std::sin(i);
        points.add(l, m, {light, -light, 0, 2 * light}, i % 2 == 1);
        (i % 2 == 1 ? odd : even) += std::polar(light, 2 * M_PI * std::remainder(b.u * l + b.v * m, 1.0));
    }
    points.add(1, 1, {}, false);
    const VisibilitySum sum = points.at(b);
    CHECK(std::abs(sum.all[0] - even - odd) < 150e-9);
    CHECK(std::abs(sum.change[0] - even + odd) < 150e-9);
    CHECK(std::abs(sum.all[1] + sum.all[0]) < 1e-9);
    CHECK(sum.all[2] == 0.0);
    CHECK(std::abs(sum.all[3] - 2.0 * sum.all[0]) < 1e-9);
    points.scale(0.5);
    CHECK(std::abs(points.at(b).all[0] - 0.5 * sum.all[0]) < 1e-9);
}

TEST_CASE("ring parts: every second pixel of a picture changes V by what it says") {
    SkyPicture picture{Image<double>(13, 8, 1), 0.01}, half = picture;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 13; ++x) {
            picture.flux.at(x, y)[0] = 1 + std::sin(x * 1.3 + y * y);
            half.flux.at(x, y)[0] = (x + y) % 2 == 0 ? 2 * picture.flux.at(x, y)[0] : 0.0;
        }
    const Baseline b{4.1, -17.3};
    const PictureVisibility whole(picture, PixelShape::kSquare), of_half(half, PixelShape::kSquare);
    const VisibilitySum sum = whole.with_change(b);
    CHECK(std::abs(sum.all[0] - whole.at(b)[0]) == 0);
    CHECK(std::abs(sum.all[0] + sum.change[0] - of_half.at(b)[0]) < 1e-12);
}

TEST_CASE("ring parts: V holds up to where a change is a hundredth of what is left") {
    const std::vector<Baseline> baselines = {{3, 0}, {0, 1}, {0, 0}, {0, -2}};
    std::vector<VisibilitySum> sums(4);
    const std::array<double, 4> light = {0.1, 0.01, 1, 0.2}, change = {0, 0.0019, 0, 0};
    for (std::size_t i = 0; i < 4; ++i) sums[i].all[0] = light[i], sums[i].change[0] = change[i];
    CHECK(std::isinf(reach_of(baselines, sums)));  // near a null there is more beyond
    sums[3].change[0] = {0, 0.00201};
    CHECK(reach_of(baselines, sums) == 2);
    sums[1].change[0] = 0.00201;
    CHECK(reach_of(baselines, sums) == 1);
}

TEST_CASE("ring parts: a mesh of pixels shows each its place, also beside the picture") {
    CameraSpec camera;
    camera.width = 6, camera.height = 4, camera.plane_width = 0.06;
    std::vector<std::array<double, 2>> places;
    for (int i = 0; i < 24; ++i) places.push_back({std::sin(7.0 * i) * 3, std::cos(5.0 * i) * 3});
    {
        const HeldMesh mesh(WarpMesh::of_pixels(places, 6, 4));
        camera.warp = mesh.name();
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 6; ++x) {
                const auto [u, v] = places[static_cast<std::size_t>(6 * y + x)];
                const Vec3 d = pixel_direction(camera, x + 0.5, y + 0.5);
                CHECK(std::fabs(-d.x / d.z - (u - 0.5) * 0.06) < 1e-12);
                CHECK(std::fabs(-d.y / d.z - (v - 0.5) * 0.04) < 1e-12);
                CHECK(shows(camera, x + 0.5, y + 0.5));
            }
    }
    CHECK(held_mesh(camera.warp) == nullptr);
}

}  // namespace
