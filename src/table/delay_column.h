// How long light has been on its way, along one column of the orbit table (shaders/planar/delay.glsl): what is left of it once the part
// that grows without bound, far out and at the horizon, is taken off.
//
// Traced backward, t falls along the ray by dt/dphi = q/V. With W = zeta'/q, V = zeta^2 A = q^2 (1 - W^2), r_* the tortoise radius and
// sigma = 1 for rays that end in the sky, -1 for those that end in the horizon, the light time from the camera (0) to a place is
//     t = [ -W/zeta + sigma (ln((1 - sigma W)/zeta) + rho) ] - [ the same at the camera ] + D,   r_* = 1/zeta - ln(zeta) + rho(zeta),
//     dD/dphi = N(zeta)/(q - sigma zeta') - zeta A'/(2 q),   N = 1 - A (1 + zeta) - zeta^2 A'/2   (Schwarzschild: 3 zeta^2/2),
// from physics of T = v_cam - v_inf, dT/dphi = 1/(q - zeta'): A has cancelled, so D is regular at the horizon on the rays that cross it,
// and far out, where N = O(zeta^2). Near the photon sphere it grows in proportion to phi.
#pragma once
#include "table/met_orbit.h"
#include "table/ray_family.h"

namespace nullscope {

// Texels (D, D_d, D_v, D_dv), v = angle over phi_end, as the orbit table's. Error: 1e-9 of D where D is not small.
OrbitTexels delay_column(const RayFamily& family, Segment segment, const FanRay& ray, const MetOrbit& orbit);

}  // namespace nullscope
