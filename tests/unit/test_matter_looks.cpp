// What the reference asks thousands of times a ray in matter, from sums and polynomials that stand for it: against closed forms and against
// what they stand for.
#include <doctest/doctest.h>

#include <array>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>

#include "light/black_body.h"
#include "reference/chebyshev.h"
#include "reference/emission.h"
#include "reference/kerr_between.h"
#include "reference/kerr_ray.h"
#include "reference/seen_light.h"
#include "reference/smooth_segment.h"

namespace {

using namespace nullscope;
using namespace nullscope::reference;

TEST_CASE("Chebyshev sums: of twelve terms, the exponential to rounding, and its integral") {
    std::array<double, 12> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::exp(0.5 * chebyshev_places<12>()[i]);
    const auto terms = chebyshev_terms(values);
    const auto sum = chebyshev_integral(terms);
    for (double x = -1; x <= 1; x += 0.0625) {
        CAPTURE(x);
        CHECK(std::fabs(chebyshev_sum(terms, x) - std::exp(0.5 * x)) < 2e-15);
        CHECK(std::fabs(chebyshev_sum(sum, x) - 2 * (std::exp(0.5 * x) - std::exp(-0.5))) < 4e-15);
    }
    // Regular within half axes that add up to 2 + sqrt 3: so many terms leave that power of it.
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 1 / (2 - chebyshev_places<12>()[i]);
    const double off = std::fabs(chebyshev_sum(chebyshev_terms(values), 0.97) - 1 / 1.03),
                 least = std::pow(2 + std::sqrt(3.0), -12);
    CHECK(off < 2 * least);
    CHECK(off > 0.01 * least);  // it can fail
}

TEST_CASE(
    "Hermite's polynomial of ninth degree: itself exactly, with its slope, and the tenth power as the remainder has "
    "it") {
    using Line = HermiteNinth<2>;
    std::array<Line::Known, Line::kPlaces> known{};
    for (std::size_t i = 0; i < known.size(); ++i) {
        const double t = Line::kAt[i];
        known[i] = {{std::pow(t, 9) - 3 * t * t + 1, std::pow(t, 10)},
                    {9 * std::pow(t, 8) - 6 * t, 10 * std::pow(t, 9)}};
    }
    const Line line(known);
    for (double t = 0; t <= 1; t += 0.03125) {
        CAPTURE(t);
        const auto [value, slope] = line(t);
        CHECK(std::fabs(value[0] - (std::pow(t, 9) - 3 * t * t + 1)) < 2e-14);
        CHECK(std::fabs(slope[0] - (9 * std::pow(t, 8) - 6 * t)) < 2e-13);
        double left = 1;  // of t^10: the product of all (t - place)^2
        for (const double at : Line::kAt) left *= (t - at) * (t - at);
        CHECK(std::fabs(std::pow(t, 10) - value[1] - left) < 2e-14);
        CHECK(left < 8.7e-6);
    }
}

TEST_CASE("matter: K_2 to 1e-12, where it is a table and beyond") {
    for (const double x : {1e-9, 1e-6, 2e-4, 0.1, 0.5, 1.0, 1.1, 2.0, 7.0, 11.8, 50.0, 300.0, 500.0}) {
        CAPTURE(x);
        CHECK(std::fabs(bessel_k2(x) / boost::math::cyl_bessel_k(2, x) - 1) < 1e-12);
    }
    CHECK(bessel_k2(1.0) == doctest::Approx(1.6248388986351775).epsilon(1e-14));  // DLMF 10.30: tables
}

TEST_CASE("matter: what a camera sees of a black body is the sum over wavelengths to 1e-12") {
    LightSpec light;
    for (double t = 90; t < 1e11; t *= 1.37) {
        CAPTURE(t);
        const Vec3 xyz = black_body_xyz(t), sum = xyz.y * into_gamut(rec709_from_xyz(xyz / xyz.y)),
                   seen = seen_black_body(2 * t, 0.5, light);
        CHECK(length(seen - sum) < 1e-12 * length(sum));
    }
    light.beaming = false;  // another temperature for its brightness than for its colour
    const Vec3 seen = seen_black_body(8000, 0.5, light), hue = black_body_xyz(4000);
    const Vec3 sum = black_body_xyz(8000).y * into_gamut(rec709_from_xyz(hue / hue.y));
    CHECK(length(seen - sum) < 1e-12 * length(sum));
}

// From places to both sides of the hole, prograde and retrograde, captured and not, over the axis too.
TEST_CASE(
    "matter about a rotating hole: an interpolant's places are the step's to 1e-12 of the distance, and so are its "
    "slopes") {
    constexpr double kNear = 30;  // r_s: where matter is looked for, of a flow that ends at 15
    for (const double spin : {0.3, 0.9, 0.998}) {
        double worst = 0, worst_slope = 0, worst_delay = 0;
        int looks = 0;
        const auto watch = [&](const KerrStep& step) {
            if (std::min(step.begin.r, step.end.r) > kNear || step.begin.r < 1.02 || step.end.r < 1.02) return;
            for (const double part : {0.0, 0.05, 0.31, 0.62, 0.97, 1.0}) {
                const double along = step.from + part * (step.to - step.from);
                const double h = 1e-5 * (step.to - step.from);  // the differences are off by its square: 3e-9
                const KerrPlace at = step.at(along);
                const KerrGlance seen = step.glance(along, true);
                worst = std::max({worst, std::fabs(seen.r / at.r - 1), length(seen.direction - at.flat() / at.r)});
                worst_delay = std::max(worst_delay, std::fabs(seen.delay - at.delay) / at.r);
                if (part > 0.01 && part < 0.99 && std::sin(at.theta) > 0.1) {
                    const KerrPlace before = step.at(along - h), after = step.at(along + h);
                    const double scale = way_between(before, after) / (2 * h) / at.r;
                    worst_slope =
                        std::max({worst_slope, std::fabs(seen.r_slope - (after.r - before.r) / (2 * h)) / at.r / scale,
                                  std::fabs(seen.theta_slope - (after.theta - before.theta) / (2 * h)) / scale});
                }
                ++looks;
            }
        };
        for (const Vec3 n :
             {Vec3{-1, 0, 0.14}, Vec3{-1, 0.05, -0.16}, Vec3{-1, 0.1, 0.02}, Vec3{-1, 0.32, 0.0}, Vec3{-1, -0.2, 0.3}})
            for (const double theta : {0.2, 1.4})
                trace_kerr(KerrHole(spin), KerrStart{20, theta, 0.7, normalized(n)}, 0, watch);
        MESSAGE("spin " << spin << ": places " << worst << ", delays " << worst_delay << ", slopes " << worst_slope
                        << " over " << looks);
        CHECK(looks > 500);
        CHECK(worst < 1e-12);
        CHECK(worst_delay < 1e-12);
        CHECK(worst_slope < 1e-7);  // of the differences
    }
}

}  // namespace
