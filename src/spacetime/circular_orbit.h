// Matter in the equatorial plane: circular geodesics, and inside the innermost stable one the fall that keeps its constants.
//
// With V = A zeta^2 and w = V'/2 (Spacetime::half_v_slope): u^t = sqrt(zeta/w), Omega^2 = zeta^2 (A - w/zeta), so that
// E = A u^t and L = r^2 Omega u^t. Stable where E falls inward: d(ln E^2)/dzeta = 2 A'/A - w'/w + 1/zeta < 0.
// About a spinning hole: in the direction of its spin, by closed forms.
#pragma once
#include <optional>

#include "spacetime/spacetime.h"

namespace nullscope {

struct CircularOrbit {
    double u_t;       // dt/dtau
    double omega;     // dphi/dt, towards growing phi; in c/r_s
    double energy;    // per rest mass
    double momentum;  // L per rest mass, r_s c
};

// Errors: nothing where there is no such geodesic (at and inside a photon sphere). Flat space: matter at rest.
std::optional<CircularOrbit> circular_orbit(const Spacetime& spacetime, double r);

// Radius in r_s of the innermost stable circular orbit; nothing where light runs straight.
std::optional<double> innermost_stable_orbit(const Spacetime& spacetime);

// Contravariant four-velocity (u^t, u^r, u^phi) of the disc's matter at r outside the horizon: circular down to the innermost
// stable orbit, falling with that orbit's energy and angular momentum inside. Continuous, with a continuous first derivative
// but for u^r, which begins as (r_isco - r)^(3/2).
struct MatterVelocity {
    double u_t, u_r, u_phi;
};
MatterVelocity disc_matter(const Spacetime& spacetime, double r);

}  // namespace nullscope
