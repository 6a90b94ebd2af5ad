// Schwarzschild orbits in closed form: (dzeta/dphi)^2 = P(zeta) = q^2 - zeta^2 + zeta^3.
//
// With D = zeta - 2/3: P = delta2 + D^2 (zeta + 1/3), delta2 = q^2 - q_crit^2, which is formed
// without rounding of q_crit = 2/(3 sqrt 3). The roots of P follow from Viete: with zeta = 1/3 + (2/3) cos(t),
// P = q^2 - q_crit^2 sin^2(3t/2). All differences of roots are products of sines (hyperbolic for q > q_crit).
//
// Four kinds of orbit: flyby (q < q_crit outside the photon sphere), inner (q < q_crit inside it), passing (q > q_crit,
// monotone from infinity to the singularity or back) and radial (q infinite).
#pragma once
#include <memory>

#include "reference/orbit.h"

namespace nullscope::reference {

std::unique_ptr<OrbitMetric> make_schwarzschild_orbits(const SpacetimeSpec& spec);

// A ray at its camera. root_p = sqrt(P(zeta0)) >= 0, beyond = zeta0 - 2/3 and lapse2 = 1 - zeta0 are given apart
// because they cannot be recomputed from zeta0 and q near the turning point, the photon sphere and the horizon.
struct SchwarzschildStart {
    double q, zeta0;
    int s;  // +1: towards the hole
    double root_p, delta2, beyond, lapse2;
};
std::unique_ptr<Orbit> make_schwarzschild_orbit(const SchwarzschildStart& start);

// T of a ray that runs outward from zeta0, T = int_0^zeta0 dzeta / (sqrt P (q + sqrt P)): quadrature in the variable
// that makes the integrand regular, relative error 1e-14.
// Two real roots near the range: e1 < 0 < e2 < e3, below = e2 - zeta0, gap = e3 - e2.
double outward_delay_real(double q, double zeta0, double minus_e1, double e2, double below, double gap);
// A conjugate pair re +- i im; beyond = zeta0 - re.
double outward_delay_pair(double q, double zeta0, double minus_e1, double re, double im, double beyond);

}  // namespace nullscope::reference
