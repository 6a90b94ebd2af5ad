// Orbits about a Reissner-Nordstrom charge without horizon, Q/M > 1: (dzeta/dphi)^2 = P = q^2 - zeta^2 (1 - zeta + kappa zeta^2).
//
// V grows without bound inward, so every ray from the sky turns, at the least root e of P that it meets, and comes back. From there
// zeta = e - s^2, P = s^2 (c1 + c2 s^2 + c3 s^4 + c4 s^6), and with the root s = sigma + i mu of the bracket that is nearest to the path
// s = sigma + mu sinh(w): in w the rate is smooth, however close to the photon sphere a ray comes. Between the two photon spheres of
// 1 < Q/M <= sqrt(9/8) rays can be trapped: they have no sky.
#pragma once
#include <memory>

#include "reference/orbit.h"

namespace nullscope::reference {

std::unique_ptr<OrbitMetric> make_naked_orbits(double charge);

}  // namespace nullscope::reference
