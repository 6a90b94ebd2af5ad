// Line integral convolution against closed forms, and the streamlines made of it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "annotate/line_convolution.h"
#include "annotate/streamlines.h"

using namespace nullscope;

namespace {

// Stokes parameters of light whose electric vector has an angle from right towards up, at each pixel.
template <class Angle>
Image<float> light_along(int width, int height, Angle angle) {
    Image<float> stokes(width, height, 4);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double twice = 2 * angle(x + 0.5 - 0.5 * width, 0.5 * height - y - 0.5);
            float* to = stokes.at(x, y);
            to[0] = 1, to[1] = static_cast<float>(0.5 * std::cos(twice)),
            to[2] = static_cast<float>(0.5 * std::sin(twice));
        }
    return stokes;
}

// A value at each pixel; right and up of the middle.
template <class Value>
Image<float> waves_of(int width, int height, Value value) {
    Image<float> image(width, height, 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            *image.at(x, y) = static_cast<float>(value(x + 0.5 - 0.5 * width, 0.5 * height - y - 0.5));
    return image;
}

Image<float> convolved(const Image<float>& noise, const Image<float>& stokes, double reach) {
    return line_convolution(noise, stokes, reach,
                            std::vector<bool>(static_cast<std::size_t>(noise.width) * noise.height, true));
}

// What interpolation between pixels leaves of a wave of k rad/px, at most: its second derivative's part.
double interpolation_error(double k) { return k * k / 8; }

}  // namespace

TEST_CASE(
    "streamlines: a wave along a constant field becomes as high as the window's transform says, one across it stays") {
    constexpr int kSide = 160;
    constexpr double kReach = 24;
    for (const double angle : {0.0, 0.4, 1.3, std::numbers::pi / 2, 2.2, -0.7}) {
        CAPTURE(angle);
        const auto stokes =
            light_along(kSide / 2, kSide / 2, [&](double, double) { return angle; });  // of half the size
        const double c = std::cos(angle), s = std::sin(angle);
        for (const double k : {0.06, 0.13, 0.2}) {
            CAPTURE(k);
            const auto along =
                convolved(waves_of(kSide, kSide, [&](double x, double y) { return std::cos(k * (x * c + y * s)); }),
                          stokes, kReach);
            const auto across =
                convolved(waves_of(kSide, kSide, [&](double x, double y) { return std::cos(k * (y * c - x * s)); }),
                          stokes, kReach);
            const double q = k * kReach, height = std::sin(q) / q / (1 - q * q / (std::numbers::pi * std::numbers::pi));
            double worst_along = 0, worst_across = 0;
            for (int y = 40; y < kSide - 40; ++y)
                for (int x = 40; x < kSide - 40; ++x) {
                    const double right = x + 0.5 - 0.5 * kSide, up = 0.5 * kSide - y - 0.5;
                    worst_along =
                        std::max(worst_along, std::abs(*along.at(x, y) - height * std::cos(k * (right * c + up * s))));
                    worst_across =
                        std::max(worst_across, std::abs(*across.at(x, y) - std::cos(k * (up * c - right * s))));
                }
            CHECK(worst_along <= interpolation_error(k) + 1e-6);
            CHECK(worst_across <= interpolation_error(k) + 1e-6);
        }
    }
}

TEST_CASE("streamlines: along a field of circles a function of the radius stays") {
    constexpr int kSide = 200;
    constexpr double kWave = 0.12;
    const auto stokes = light_along(kSide, kSide, [](double x, double y) { return std::atan2(x, -y); });
    const auto rings = [](double x, double y) { return std::cos(kWave * std::hypot(x, y)); };
    const auto texture = convolved(waves_of(kSide, kSide, rings), stokes, 40);
    double worst = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const double right = x + 0.5 - 0.5 * kSide, up = 0.5 * kSide - y - 0.5, r = std::hypot(right, up);
            if (r > 20 && r < 0.45 * kSide) worst = std::max(worst, std::abs(*texture.at(x, y) - rings(right, up)));
        }
    CHECK(worst <= interpolation_error(kWave) + 1e-4);
    // Along rays from the middle it does not.
    const auto radial = light_along(kSide, kSide, [](double x, double y) { return std::atan2(y, x); });
    CHECK(std::abs(*convolved(waves_of(kSide, kSide, rings), radial, 40).at(150, 100) - rings(50.5, -0.5)) > 0.2);
}

TEST_CASE("streamlines: lines end where nothing is polarised, and nothing that is not finite comes out") {
    constexpr int kWidth = 60, kHeight = 20;
    auto stokes = light_along(kWidth, kHeight, [](double, double) { return 0.0; });
    for (int y = 0; y < kHeight; ++y)
        for (int x = 28; x < 32; ++x) stokes.at(x, y)[1] = 0;
    stokes.at(50, 5)[1] = std::numeric_limits<float>::quiet_NaN();
    stokes.at(50, 8)[2] = std::numeric_limits<float>::infinity();
    const auto texture =
        convolved(waves_of(kWidth, kHeight, [](double x, double) { return x < 0 ? 0.0 : 1.0; }), stokes, 20);
    for (int y = 12; y < kHeight; ++y) {
        CHECK(*texture.at(20, y) == 0);  // the ones are behind the gap
        CHECK(*texture.at(40, y) == 1);
    }
    CHECK(std::ranges::all_of(texture.data, [](float value) { return std::isfinite(value); }));
    stokes.at(20, 10)[0] = std::numeric_limits<float>::quiet_NaN();
    stokes.at(10, 10)[0] = std::numeric_limits<float>::infinity();
    const auto marks = streamline_marks(stokes, kWidth, kHeight);
    REQUIRE(marks.size() == 1);
    CHECK(marks[0].rgba.at(20, 10)[3] == 0);
    CHECK(std::ranges::any_of(marks[0].rgba.data, [](unsigned char value) { return value > 100; }));
}

TEST_CASE("streamlines: they are black, the same each time, and as dark as the polarised fraction says") {
    constexpr int kWidth = 320, kHeight = 180;
    auto stokes = light_along(kWidth, kHeight, [](double, double) { return 0.3; });
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            float* light = stokes.at(x, y);
            if (x >= 160) light[1] *= 0.5f, light[2] *= 0.5f;
            if (y >= 150) light[0] *= 0.005f, light[1] *= 0.005f, light[2] *= 0.005f;
        }
    const auto marks = streamline_marks(stokes, kWidth, kHeight);
    REQUIRE(marks.size() == 1);
    const Image<unsigned char>& rgba = marks[0].rgba;
    REQUIRE(rgba.width == kWidth);
    REQUIRE(rgba.height == kHeight);
    CHECK(streamline_marks(stokes, kWidth, kHeight)[0].rgba.data == rgba.data);
    const auto mean = [&](int left, int right, int top, int bottom) {
        double sum = 0;
        int colours = 0;
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) {
                colours += rgba.at(x, y)[0] + rgba.at(x, y)[1] + rgba.at(x, y)[2];
                sum += rgba.at(x, y)[3];
            }
        CHECK(colours == 0);
        return sum / ((right - left) * (bottom - top));
    };
    const double full = mean(0, 150, 0, 140), half = mean(170, 320, 0, 140);
    CHECK(full > 70);
    CHECK(std::abs(half / full - 0.5) < 0.05);
    CHECK(std::abs(mean(0, 150, 155, 180) / full - 0.1) < 0.05);  // a tenth of the light that has its full contrast
}

TEST_CASE("streamlines: their light is of the same view") {
    Scene scene;
    const Scene small = streamline_scene(scene, 3840, 2160);
    CHECK(small.camera.width == 640);
    CHECK(small.camera.height == 360);
    CHECK(std::abs(small.camera.pixel_aspect / scene.camera.pixel_aspect - 1) < 1e-12);
    const Scene same = streamline_scene(scene, 200, 100);
    CHECK(same.camera.width == 200);
    CHECK(same.camera.height == 100);
}
