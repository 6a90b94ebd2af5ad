// Frames of observers about a rotating hole, regular where they are.
//
// With the null vectors of the ingoing coordinates (v, r, theta, phi~), n = -d_r and l = (2 (r^2 + a^2) d_v + 2 a d_phi~ + Delta d_r)/Sigma,
//     e_0 = (outward n + l/outward)/2,   e_1 = (l/outward - outward n)/2,   e_2 = d_theta/sqrt(Sigma),
//     e_3 = (a sin(theta) d_v + d_phi~/sin(theta))/sqrt(Sigma)
// is orthonormal for any outward > 0; with inward = Delta/(Sigma outward) it is what a radial frame (radial_frame.h) is without spin, to
// which it falls back: 0 inward at the horizon and negative inside. outward = inward = sqrt(Delta/Sigma) is Carter's. The observer's own
// frame moves along e_3 with the speed `azimuthal_velocity`.
//
// phi~ = phi + int a/Delta dr, the azimuth of what falls in, equal to Boyer and Lindquist's far away: regular at the outer horizon,
// where phi winds without end.
#pragma once
#include <optional>

#include "spacetime/axial_metric.h"
#include "spacetime/radial_frame.h"

namespace nullscope {

struct SpinFrame {
    RadialFrame radial;
    double azimuthal_velocity = 0;
};

// What the formulas have of a place.
struct SpinPlace {
    double a, r, sine, cosine;
    double delta, sigma, across;  // Delta, a product; Sigma; r^2 + a^2
    double two_mass;              // 2 m(r)
};
SpinPlace spin_place(const AxialMetric& metric, double r, double theta);

// Where the ergosphere ends at this theta, r_s.
double static_limit(const AxialMetric& metric, double theta);

// Outside the outer horizon:
SpinFrame carter_frame(const SpinPlace& place);  // sees both families of principal light straight outward and inward
SpinFrame zamo_frame(const SpinPlace& place);    // without angular momentum: goes round as space is dragged
std::optional<SpinFrame> static_frame(
    const SpinPlace& place);  // at rest against the far sky; nothing in the ergosphere
// On the geodesic of constant r that is never further from the equatorial plane than here: a circle in it, its relatives elsewhere.
// Towards growing phi, or towards falling phi. Nothing at and inside the light's own such orbit.
std::optional<SpinFrame> orbiting_frame(const SpinPlace& place, bool eastward);
// Anywhere outside the inner horizon: falling with this energy > 0 per rest mass, without angular momentum, along theta = constant for now
// (energy 1: for ever). Where energy^2 is below lapse2(place) there is none.
SpinFrame falling_frame(const SpinPlace& place, double energy);
double zamo_lapse2(const SpinPlace& place);  // energy^2 of the camera without angular momentum at rest; below 0 inside

}  // namespace nullscope
