// Orbits in the wormhole of James, von Tunzelmann, Franklin and Thorne (2015), integrated over the proper length l as the metric
// gives it: dphi = b dl/(R sqrt(R^2 - b^2)), R = rho + M f(x), x = 2 (|l| - a)/(pi M), f = x atan x - ln(1 + x^2)/2.
//
// b > rho: the ray turns where R(x_t) = b; x = x_t cosh(w). b < rho: it passes; x = e sinh(w), e^2 = (rho^2 - b^2)/(rho M), at most 1
// (atan has its singularities at x = +-i). In w the rate is smooth, with its singularities at |Im w| = pi/2. All that nearly vanishes
// (R - b, rho - b, x - x_t) is formed on its own, in long double.
#pragma once
#include <memory>

#include "reference/orbit.h"

namespace nullscope::reference {

std::unique_ptr<OrbitMetric> make_dneg_orbits(const SpacetimeSpec& spec);

}  // namespace nullscope::reference
