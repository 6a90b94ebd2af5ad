// The camera about a rotating hole: what a view direction n along its frame's (e_r, e_theta, e_phi) gives for the tangent of the ray traced
// backward, per unit of frequency there. Every one is a linear form of n, formed here in double (the photon's have the other sign):
//     E, L/sin(theta) and d(1/r)/d tau (tau: Mino's time) = constant + radial n_r + around n_phi,
//     L/sin(theta) - a E sin(theta) = carter + carter_slope n_phi,   p_theta = p_theta n_theta.
// Nothing is divided by Delta or sin(theta): they hold on the horizon, inside it, and on the axis. Lengths in r_s.
#pragma once
#include "observer/spin_frame.h"

namespace nullscope {

struct SpinForm {
    double constant, radial, around;
    double of(double n_r, double n_phi) const { return constant + radial * n_r + around * n_phi; }
};
struct SpinForms {
    SpinForm energy, across, climb;
    double carter, carter_slope, p_theta;
};
SpinForms spin_forms(const SpinPlace& place, const SpinFrame& frame);

// E - a L/(r^2 + a^2) of the photon at the outer horizon, (r_+^2 + a^2)/r_+^2 times: what of its energy does not go round with
// it. Formed without E and L, which next to the horizon are much larger and all but equal.
SpinForm horizon_form(const AxialMetric& metric, const SpinPlace& place, const SpinFrame& frame);
// Is a camera at r so close to the outer horizon, on either side, that its rays need this form (shaders/mino/near.glsl)?
bool is_next_to_horizon(const Spacetime& spacetime, double r);

}  // namespace nullscope
