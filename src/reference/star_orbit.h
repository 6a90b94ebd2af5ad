// A star's orbits: those of the Schwarzschild exterior until they meet the surface, found by bracketing zeta_at(angle) = 1/radius.
#pragma once
#include <memory>

#include "reference/orbit.h"

namespace nullscope::reference {

std::unique_ptr<OrbitMetric> make_star_orbits(const SpacetimeSpec& spec);

}  // namespace nullscope::reference
