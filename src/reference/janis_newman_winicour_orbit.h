// Orbits about Janis, Newman and Winicour's mass: with x = r_g/r, y = 1 - x, qg = q r_g, (dx/dphi)^2 = y^(2 - 2g) P, P = qg^2 - W,
// W = x^2 y^(2g - 1). Integrals over x itself, or over s with x = x_t -+ s^2 about a turning point, or over ln(y) on the way into the
// singular surface, by Gauss-Kronrod panels halved until nothing changes, in long double.
#pragma once
#include <memory>

#include "reference/orbit.h"

namespace nullscope::reference {

std::unique_ptr<OrbitMetric> make_janis_newman_winicour_orbits(const SpacetimeSpec& spec);

}  // namespace nullscope::reference
