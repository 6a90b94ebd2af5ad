// Straight lines, zeta = q sin(phi - phi_infinity): the flat case of the orbit interface.
#pragma once
#include <memory>

#include "reference/orbit.h"

namespace nullscope::reference {

std::unique_ptr<OrbitMetric> make_minkowski_orbits(const SpacetimeSpec& spec);

}  // namespace nullscope::reference
