// How fast matter on circular orbits goes round, by radius, for the shader: Omega^2 = P/r^3 of metrics without rotation. Those that have
// circular_rate_numbers() do without it.
#pragma once
#include <array>

#include "spacetime/spacetime.h"

namespace nullscope {

// P as a polynomial in x = (ln r - middle) per_half, in [-1, 1] between two radii: through twelve Chebyshev nodes. Error, over the largest P:
// none for a mass alone, 1e-8 with charge, 3e-5 for a regular core, all of them out to 1,000 times the inner radius (7e-7 out
// to thirty times); 2e-7 with a cosmological constant, out to ten times (tests/unit/test_disc_rate.cpp).
struct DiscRate {
    double middle, per_half;
    std::array<double, 12> terms;  // of 1, x, x^2, ...
    double operator()(double r) const;
};
DiscRate disc_rate(const Spacetime& spacetime, double inner, double outer);

}  // namespace nullscope
