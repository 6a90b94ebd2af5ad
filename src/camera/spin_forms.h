// The camera at rest about a spinning hole, without angular momentum: what a look direction n along its (e_r, e_theta, e_phi) gives for
// the tangent of the ray traced backward, per unit of frequency there. Lengths in r_s.
//     E = energy + energy_slope n_phi                          (minus the photon's)
//     L/sin(theta) = momentum n_phi,   L/sin(theta) - a E sin(theta) = carter + carter_slope n_phi,   p_theta = p_theta n_theta
//     d(1/r)/d tau = -zeta_slope n_r                           (tau: Mino's time)
// Carter's frame, in which both are linear without a difference, moves at v = a sin(theta) sqrt(Delta)/(r^2 + a^2) in this one.
#pragma once
#include "spacetime/spacetime.h"

namespace nullscope {

struct SpinForms {
    double energy, energy_slope, carter, carter_slope, p_theta, momentum, zeta_slope;
};
// r outside the horizon; any theta.
SpinForms spin_forms(const Spacetime& spacetime, double r, double theta);

}  // namespace nullscope
