// Sums of Chebyshev's polynomials in the place of a formula, and orbits found by them.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "reference/octave_sums.h"
#include "reference/orbit.h"
#include "scene/scene.h"

using namespace nullscope;

namespace {

using reference::OctaveSums;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

long double shape(long double zeta) { return std::sqrt(zeta) / (1 + zeta * zeta * zeta); }
long double difference(long double zeta, long double end) {  // as a product: no digits are lost
    const long double a = std::sqrt(zeta), b = std::sqrt(end);
    const long double cubes = zeta * zeta + zeta * end + end * end,
                      low = (1 + zeta * zeta * zeta) * (1 + end * end * end);
    return ((1 + end * end * end) / (a + b) - b * cubes) / low;
}

}  // namespace

TEST_CASE("octave sums: values and differences have all digits, of a function with a root at 0 and poles beside") {
    const OctaveSums sums(shape, 1.25L, 12);
    double value = 0, apart = 0;
    long held = 0;
    for (long double zeta = 4e-4L; zeta < 1.25L; zeta *= 1.00713L) {
        const OctaveSums::Piece* piece = sums.piece(static_cast<double>(zeta));
        REQUIRE(piece != nullptr);
        value = std::fmax(value, static_cast<double>(std::abs((*piece)(zeta) / shape(zeta) - 1)));
        const reference::OctaveDifferences differences(*piece, zeta);
        for (const long double off : {0.0L, 1e-17L, 1e-12L, -1e-6L, 1e-3L, -0.02L, 0.04L}) {
            const double other = static_cast<double>(zeta * (1 + off));
            if (!differences.holds(other)) continue;
            ++held;
            const long double exact = difference(other, zeta), size = shape(zeta) / zeta;
            apart = std::fmax(apart, static_cast<double>(std::abs(differences(other) - exact) / size));
        }
    }
    fmt::print("octave sums: values off by {:.2g}, {} differences by {:.2g} of f/zeta\n", value, held, apart);
    CHECK(value <= 1e-16);
    CHECK(apart <= 4 * kEpsilon);
    CHECK(held > 6000);
}

TEST_CASE("octave sums: there are none outside of them, nor where a function is not smooth") {
    const OctaveSums sums([](long double zeta) { return std::abs(zeta - 0.3L); }, 1, 10);
    CHECK(sums.piece(0.3) == nullptr);
    CHECK(sums.piece(0.2) != nullptr);
    CHECK(sums.piece(1) != nullptr);
    for (const double outside : {1.01, 2.0, 1e-4, 0.0, -0.5, std::nan(""), 1e300})
        CHECK(sums.piece(outside) == nullptr);
}

// Schwarzschild's hole with r measured from elsewhere has no short sums: A = 1 - 1/(r + 0.5), R = r + 0.5.
TEST_CASE("formula: orbits by sums are the closed ones, however near to the critical ray") {
    constexpr double kRoundings = 16;  // of the angle and, times what it is worth, of q
    SpacetimeSpec spec{"formula", {}};
    spec.parameters.formulas = {{"A", "1 - 1/(r + 0.5)"}, {"B", "1/(1 - 1/(r + 0.5))"}, {"R", "r + 0.5"}};
    const auto moved = reference::make_metric(spec), hole = reference::make_metric(SpacetimeSpec{"schwarzschild", {}});
    REQUIRE(moved);
    REQUIRE(hole);
    const double critical = 2 / (3 * std::sqrt(3.0));
    double worst = 0, places = 0;
    long rays = 0;
    for (const double radius : {1.125, 1.25, 2.0, 3.0, 17.0, 257.0, 1e6 + 0.5})
        for (double off = 1e-9; off < 30; off *= 1.9)
            for (const double q : {critical * (1 + off), critical * (1 - off), critical * std::exp(-off)})
                for (const int s : {1, -1}) {
                    if (!(q > 1e-7)) continue;
                    const auto one = (*moved)->orbits()->from_reduced({q, 1 / (radius - 0.5), s}),
                               other = (*hole)->orbits()->from_reduced({q, 1 / radius, s});
                    if (!one || !other) continue;
                    REQUIRE((*one)->fate() == (*other)->fate());
                    const double angle = (*other)->angle(), turning = 1 - q * q * std::pow(radius, 3) / (radius - 1);
                    if (!(angle > 0) || std::abs(turning) < 1e-3) continue;  // there zeta0 is rounded otherwise
                    ++rays;
                    const double worth = angle + 1 / std::abs(q / critical - 1) + 1 / std::abs(turning);
                    worst = std::fmax(worst, std::fabs((*one)->angle() - angle) / (kEpsilon * worth));
                    for (const double part : {0.03, 0.3, 0.7, 0.97}) {
                        const double zeta = (*other)->zeta_at(part * angle),
                                     slope = std::sqrt(std::fmax(q * q - zeta * zeta * (1 - zeta), 0)),
                                     off_place = 1 / (1 / (*one)->zeta_at(part * angle) + 0.5) - zeta;
                        places = std::fmax(places, std::fabs(off_place) / (kEpsilon * (zeta + worth * slope)));
                    }
                }
    fmt::print("formula, {} rays: angles off by {:.2g} roundings, places by {:.2g}\n", rays, worst, places);
    CHECK(worst < kRoundings);
    CHECK(places < kRoundings);
    CHECK(rays > 300);
}
