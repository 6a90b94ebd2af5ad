// Visibilities: sums over pixels against long double and against closed forms of rings, discs, Gaussians and pairs of points; signs; what they cost.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <complex>
#include <ctime>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "telescope/scattering.h"
#include "telescope/visibility.h"

namespace {

using namespace nullscope;

constexpr double kMicroarcsec = M_PI / 180 / 3600e6;
constexpr PixelShape kShapes[] = {PixelShape::kPoint, PixelShape::kSquare, PixelShape::kTriangle};

SkyPicture dark_sky(int width, int height, double pixel, int planes = 1) {
    return {Image<double>(width, height, planes), pixel};
}

SkyPicture random_sky(int width, int height, int planes, unsigned seed) {
    SkyPicture picture = dark_sky(width, height, 0.7 * kMicroarcsec, planes);
    std::mt19937 random(seed);
    for (double& value : picture.flux.data) value = static_cast<double>(random()) / 4294967296.0 - 0.2;
    return picture;
}

// The places of points of light on a circle or elsewhere, each shared by the four pixels around it.
void deposit(SkyPicture& picture, double east, double north, double flux) {
    const double x = 0.5 * (picture.flux.width - 1) - east / picture.pixel,
                 y = 0.5 * (picture.flux.height - 1) - north / picture.pixel;
    const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
    const double right = x - left, below = y - top;
    picture.flux.at(left, top)[0] += flux * (1 - right) * (1 - below);
    picture.flux.at(left + 1, top)[0] += flux * right * (1 - below);
    picture.flux.at(left, top + 1)[0] += flux * (1 - right) * below;
    picture.flux.at(left + 1, top + 1)[0] += flux * right * below;
}

// Where f changes its sign between the two.
double root_of(const std::function<double(double)>& f, double low, double high) {
    const bool positive = f(low) > 0;
    REQUIRE(positive != (f(high) > 0));
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        ((f(middle) > 0) == positive ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

// The real part along the direction 30 degrees east of north, at a baseline of x/size.
std::function<double(double)> along(const PictureVisibility& picture, double size) {
    return [&picture, size](double x) {
        return picture.at({x / size * std::sin(M_PI / 6), x / size * std::cos(M_PI / 6)})[0].real();
    };
}

// The sum as its definition has it, in long double; each pixel as n x n points, or weighted ones.
std::complex<long double> by_definition(const SkyPicture& picture, int plane, Baseline baseline) {
    std::complex<long double> sum;
    for (int y = 0; y < picture.flux.height; ++y)
        for (int x = 0; x < picture.flux.width; ++x) {
            const long double east = (0.5L * picture.flux.width - 0.5L - x) * picture.pixel,
                              north = (0.5L * picture.flux.height - 0.5L - y) * picture.pixel;
            const long double turns = baseline.u * east + baseline.v * north;
            sum += static_cast<long double>(picture.flux.at(x, y)[plane]) *
                   std::polar(1.0L, 2 * std::numbers::pi_v<long double> * turns);
        }
    return sum;
}

TEST_CASE("visibility: a picture's is the sum over its pixels to 1e-12") {
    double most = 0;
    for (const auto& [width, height, planes] : {std::array{13, 9, 1}, std::array{40, 31, 4}, std::array{1, 1, 1}}) {
        const SkyPicture picture = random_sky(width, height, planes, 7);
        const PictureVisibility found(picture, PixelShape::kPoint);
        double light = 0;
        for (const double value : picture.flux.data) light += std::fabs(value);
        for (const Baseline b : {Baseline{0, 0}, Baseline{3e9, -5e9}, Baseline{-8e10, 1e11}, Baseline{5e12, -4e12}})
            for (int plane = 0; plane < planes; ++plane) {
                const auto meant = std::complex<double>(by_definition(picture, plane, b));
                most = std::max(most, std::abs(found.at(b)[static_cast<std::size_t>(plane)] - meant) / light);
            }
        CHECK(found.at({0, 0})[0].real() == doctest::Approx(total_flux(picture)).epsilon(1e-13));
    }
    MESSAGE("off by ", most, " of the light");
    CHECK(most < 1e-12);
}

TEST_CASE("visibility: shapes of pixels are their light's") {
    SkyPicture one = dark_sky(3, 3, 2.0);  // whose middle pixel is [-1, 1] x [-1, 1]
    one.flux.at(1, 1)[0] = 1;
    constexpr int kParts = 1000;
    for (const Baseline b : {Baseline{0.1, 0.2}, Baseline{0.33, -0.47}, Baseline{0.7, 0.0}}) {
        double square = 0, triangle = 0;  // by the middles of parts of (-1, 1), and of (-2, 2) with linear weight
        const auto mean = [&](double frequency, double half, bool weighted) {
            double sum = 0, weights = 0;
            for (int i = 0; i < kParts; ++i) {
                const double x = half * ((i + 0.5) / kParts * 2 - 1), weight = weighted ? 1 - std::fabs(x) / half : 1;
                sum += weight * std::cos(2 * M_PI * frequency * x), weights += weight;
            }
            return sum / weights;
        };
        square = mean(b.u, 1, false) * mean(b.v, 1, false);
        triangle = mean(b.u, 2, true) * mean(b.v, 2, true);
        for (const auto& [shape, meant] :
             {std::pair{PixelShape::kPoint, 1.0}, {PixelShape::kSquare, square}, {PixelShape::kTriangle, triangle}})
            CHECK(std::abs(PictureVisibility(one, shape).at(b)[0] - meant) < 1e-4);
    }
}

TEST_CASE("visibility: light in the east has a positive phase on a baseline to the east") {
    SkyPicture picture = dark_sky(64, 48, kMicroarcsec);
    picture.flux.at(20, 30)[0] = 1;  // left of the middle, 11.5 px, and below it, 6.5 px
    const double turn = 2 * M_PI * kMicroarcsec * 1e9;
    for (const PixelShape shape : kShapes) {
        const PictureVisibility found(picture, shape);
        CHECK(std::arg(found.at({1e9, 0})[0]) == doctest::Approx(11.5 * turn).epsilon(1e-9));
        CHECK(std::arg(found.at({0, 1e9})[0]) == doctest::Approx(-6.5 * turn).epsilon(1e-9));
        CHECK(std::arg(found.at({2e9, -3e9})[0]) == doctest::Approx((2 * 11.5 + 3 * 6.5) * turn).epsilon(1e-9));
        CHECK(std::abs(found.at({-1e9, 2e9})[0] - std::conj(found.at({1e9, -2e9})[0])) < 1e-15);
    }
}

// Within 0.1 % of closed forms, of pictures whose pixels are a hundredth of the source.
constexpr double kOfPicture = 1e-3;

TEST_CASE("visibility: a thin ring's nulls and extremes are those of J0") {
    const double diameter = 42 * kMicroarcsec;
    SkyPicture picture = dark_sky(256, 256, diameter / 200);
    constexpr int kPoints = 20000;
    for (int i = 0; i < kPoints; ++i)
        deposit(picture, 0.5 * diameter * std::sin(2 * M_PI * i / kPoints),
                0.5 * diameter * std::cos(2 * M_PI * i / kPoints), 1.0 / kPoints);
    for (const PixelShape shape : kShapes) {
        const PictureVisibility found(picture, shape);
        const auto light = along(found, diameter);
        const double null = root_of(light, 0.6, 0.9);
        CHECK(null == doctest::Approx(0.7654797496).epsilon(kOfPicture));
        CHECK(null / diameter == doctest::Approx(3.7593e9).epsilon(kOfPicture));
        CHECK(light(1.2196698913) == doctest::Approx(-0.4027593957).epsilon(kOfPicture));
        for (const double off : {-0.05, 0.05}) CHECK(light(1.2196698913) < light(1.2196698913 + off));
        for (const double x : {0.2, 0.5, 1.0})
            CHECK(light(x) == doctest::Approx(std::cyl_bessel_j(0, M_PI * x)).epsilon(kOfPicture));
    }
}

TEST_CASE("visibility: a uniform disc's null") {
    SkyPicture picture = dark_sky(256, 256, 0.2 * kMicroarcsec);
    const double diameter = 200 * picture.pixel;
    constexpr int kParts = 16;  // of a pixel's side
    for (int y = 0; y < 256 * kParts; ++y)
        for (int x = 0; x < 256 * kParts; ++x)
            if (std::hypot(x + 0.5 - 128 * kParts, y + 0.5 - 128 * kParts) < 100 * kParts)
                picture.flux.at(x / kParts, y / kParts)[0] += 1;
    for (double& value : picture.flux.data) value /= M_PI * 1e4 * kParts * kParts;
    const PictureVisibility found(picture, PixelShape::kPoint);
    const auto light = along(found, diameter);
    CHECK(root_of(light, 1.1, 1.4) == doctest::Approx(1.2196698913).epsilon(kOfPicture));
    for (const double x : {0.3, 0.8, 1.6})
        CHECK(light(x) == doctest::Approx(2 * std::cyl_bessel_j(1, M_PI * x) / (M_PI * x)).epsilon(kOfPicture));
}

TEST_CASE("visibility: a Gaussian, and what scattering makes of a point") {
    SkyPicture picture = dark_sky(256, 256, 0.4 * kMicroarcsec);
    const double width = 20 * kMicroarcsec;
    double sum = 0;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) {
            const double off = std::hypot(x - 127.5, y - 127.5) * picture.pixel / width;
            sum += picture.flux.at(x, y)[0] = std::exp(-4 * M_LN2 * off * off);
        }
    const PictureVisibility found(picture, PixelShape::kPoint);
    const auto light = along(found, 1);
    const double half = root_of([&](double q) { return light(q) - 0.5 * sum; }, 3e9, 6e9);
    CHECK(half == doctest::Approx(4.5509e9).epsilon(2e-5));
    // An ellipse of these widths blurs the same: at 1 cm, 0.02 mas; its half is the picture's.
    const ScatteringKernel kernel{0.02, 0.01, M_PI / 3};
    const double hz = 2.99792458e10;
    const Baseline on{half * std::sin(M_PI / 3), half * std::cos(M_PI / 3)},
        across{2 * half * std::cos(M_PI / 3), -2 * half * std::sin(M_PI / 3)};
    CHECK(scattering(kernel, on, hz) == doctest::Approx(0.5).epsilon(2e-5));
    CHECK(scattering(kernel, across, hz) == doctest::Approx(0.5).epsilon(2e-5));
    CHECK(scattering(kernel, {0, 0}, hz) == 1);
    CHECK(std::log(scattering(kernel, on, 2 * hz)) == doctest::Approx(std::log(0.5) / 16).epsilon(1e-4));
    CHECK(scattering(kSgrAScattering, {5e9, 5e9}, 230e9) < scattering(kSgrAScattering, {5e9, -5e9}, 230e9));
}

TEST_CASE("visibility: two points beat, the nearer one's share deep") {
    SkyPicture picture = dark_sky(128, 128, kMicroarcsec);
    picture.flux.at(40, 64)[0] = 2, picture.flux.at(90, 64)[0] = 1;  // 50 px apart in the east and the west
    const PictureVisibility found(picture, PixelShape::kPoint);
    const double apart = 50 * kMicroarcsec, north = 0.5 * kMicroarcsec;
    for (const double turns : {0.0, 0.25, 0.5, 1.0, 7.75}) {
        const double u = turns / apart;
        CHECK(std::abs(found.at({u, 0})[0]) ==
              doctest::Approx(std::abs(2.0 + std::polar(1.0, 2 * M_PI * turns))).epsilon(1e-12));
        const double east_of_middle = 0.5 * (23.5 - 26.5) * kMicroarcsec;  // the middle between both
        const auto centred = found.at({u, 3e9})[0] * std::polar(1.0, -2 * M_PI * (u * east_of_middle - 3e9 * north));
        CHECK(std::abs(centred - (2.0 * std::polar(1.0, M_PI * turns) + std::polar(1.0, -M_PI * turns))) < 1e-12);
    }
}

// Processor time of all threads: a day's scans of M87* with the Event Horizon Telescope are 843 baselines.
TEST_CASE("visibility: 4000 baselines of 256 x 256 pixels take less than a core-second") {
    const PictureVisibility picture(random_sky(256, 256, 1, 3), PixelShape::kPoint);
    std::vector<Baseline> baselines;
    for (int i = 0; i < 4000; ++i) baselines.push_back({1e6 * i, 2e6 * i});
    const std::clock_t begun = std::clock();
    const std::vector<Visibility> found = picture.at(baselines);
    const double seconds = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
    MESSAGE(seconds, " core-s");
#ifndef NULLSCOPE_SANITIZED  // of code as it ships
    CHECK(seconds < 1.0);
#endif
    for (const std::size_t i : {0u, 1999u, 3999u}) CHECK(found[i] == picture.at(baselines[i]));
}

}  // namespace
