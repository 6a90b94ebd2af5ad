// Reissner-Nordstrom orbits by quadrature: (dzeta/dphi)^2 = P(zeta) = q^2 - zeta^2 + zeta^3 - kappa zeta^4, kappa = (Q/2M)^2.
//
// Every orbit is one or two monotone legs, each in a variable w in which its integrand is smooth:
//   from a turning point e, zeta = e -+ gamma sinh^2(w): P is expanded about e, so that nothing cancels there, and gamma is the
//       distance to the neighbouring root, so that nothing is steep next to the critical ray;
//   over the photon sphere, zeta = zeta_c + epsilon sinh(w): P = delta2 + (zeta - zeta_c)^2 g(zeta).
// Legs are cut into panels of 1/2 with 20 Gauss nodes. Roots are found in long double.
#pragma once
#include <memory>

#include "reference/orbit.h"

namespace nullscope::reference {

std::unique_ptr<OrbitMetric> make_reissner_nordstrom_orbits(const SpacetimeSpec& spec);

}  // namespace nullscope::reference
