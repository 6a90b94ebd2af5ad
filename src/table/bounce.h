// Swept angles where V grows without bound inward (spacetime.h: Barrier): every ray turns and comes back, and there is no deflection table.
//
// dphi = dx / sqrt(P), P = d - x (c1 + x (c2 + x (c3 + x c4))), x = zeta - zeta_d, d = q^2 - V(zeta_d). With the turning point e, the
// least root above the camera, P = (e - x) Q(x), Q a cubic by division whose constant is d/e; x = e - s^2 leaves dphi = 2 ds/sqrt(Q),
// taken by Gauss panels that are halved until halving changes nothing: they crowd about the photon sphere by themselves.
#pragma once
#include "spacetime/spherical_metric.h"

namespace nullscope {

// Rays that turn far outside of zeta_d have their digits in q, not in d: there x = zeta, V = zeta^2 (1 + zeta (...)) and d = q^2.
//
// Angle from the camera at zeta0 to the sky of the ray with q, d as above (without cancellation) and q cos(beta), positive inward.
// Error 1e-11, from any distance. Some hundred to a thousand square roots.
double bounce_to_sky(const Barrier& barrier, double zeta0, double q, double d, double inward);

}  // namespace nullscope
