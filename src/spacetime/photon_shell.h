// Light on circles about a hole: the photon sphere, and about a rotating hole the spherical photon orbits of its photon shell; and what
// rays next to them do. Every half orbit, from one turning point of theta to the other (a half turn, pi, without spin), divides by
// exp(gamma) how far a ray is from the critical one, adds `delay` to its time and `azimuth` to its azimuth. So each subring of the photon
// ring is exp(-gamma) as wide as the one before, later by `delay`, and turned by `drag`.
//
// Without spin phi = -A ln d + B of a ray at the relative distance d, with A = h(pi/2) of spherical_metric.h or 1/sqrt(-V''/2):
//     gamma = pi/A,   delay = pi b_c,   lambda^2 + eta = b_c^2,   b_c = 1/q_crit.
// Rotating (Bardeen 1973; Teo, Gen. Relativ. Gravit. 35, 1909 (2003); Gralla and Lupsasca, Phys. Rev. D 101, 044031 (2020); with charge2 in
// Delta), with x = r - r_+, gap = r_+ - r_-, Delta = x (x + gap), s = Delta' = 2 x + gap, Mino's time and energy 1:
//     X = r^2 + a^2 - a lambda = 4 r Delta/s,   K = eta + (lambda - a)^2 = 16 r^2 Delta/s^2,   R''/2 = 2 r (s^3 + gap^2)/s^2.
// Theta's motion is cos(theta) = sqrt(u) sin(psi), dpsi/dtau = W, with P = -a^2 u_-, u = u_+ of the zeros of its potential in cos^2(theta):
//     2 P = w + sqrt(w^2 + 4 a^2 eta),  w = eta + lambda^2 - a^2,   u = eta/P,   W^2 = P + a^2 u sin^2(psi).
// A half orbit is psi from -pi/2 to pi/2; with G = integral of dpsi/W and Y = P + a^2
//     gamma = sqrt(R''/2) G,   drag = a (2 r + 1)/s G,
//     azimuth - drag = integral of lambda/(W sin^2(theta)) = +-pi + (lambda a^2/sqrt Y) integral of dpsi/(W (sqrt Y + W)),
//     delay = [r^2 + 4 r (r - charge2)/s] G + a^2 integral of cos^2(theta)/W.
// Every one is a sum of terms of one sign but for the sign of lambda. The integrands are smooth and of period pi, and the midpoint rule of
// 12 points is exact to rounding (its error falls as exp(-2 n asinh(sqrt(P/(a^2 u)))), P > 13 a^2 u). Errors: 1e-14 relative; where the
// orbit is next to an extremal horizon, that of gap over its own size.
#pragma once
#include "base/result.h"
#include "spacetime/axial_metric.h"

namespace nullscope {

struct PhotonOrbit {
    double r;  // the metric's; wormholes: l
    double lambda,
        eta;  // critical impact parameters: angular momentum about the axis over energy, r_s, and Carter's constant over its square
    double gamma;  // Lyapunov exponent of a half orbit
    // Of the azimuth in a half orbit: the part of the hole's rotation, without lambda/sin^2(theta); and all of it, +pi or -pi without
    // spin. Light over the poles, lambda = 0, turns by pi there towards growing phi. rad.
    double drag, azimuth;
    double delay;  // of a half orbit, r_s/c: coordinate time
};

// The orbit of light that crosses the polar angle theta at the angle psi from e_phi, in [0, pi], as an observer of Carter's tetrad (or one
// at rest without spin) sees it: theta = pi/2 has all orbits, prograde (0) to retrograde (pi); theta = 0 the one over the poles.
// Errors: no photon sphere that light can reach, a wormhole's tube, whose orbits no exponent describes, or no orbit outside the horizon
// of an extremal hole. Microseconds.
Result<PhotonOrbit> photon_orbit(const Spacetime& spacetime, double theta, double psi);
// The one at this radius. Errors: outside of the shell.
Result<PhotonOrbit> photon_orbit_at(const AxialMetric& metric, double r);

}  // namespace nullscope
