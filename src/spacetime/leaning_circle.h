// Matter of a disc that leans, about a rotating hole: on circles about the disc's own axis, which are no geodesics there.
//
// In Boyer and Lindquist's coordinates taken as flat spherical ones, u = u^t (d_t + Omega times the turn about the disc's axis), with
//     Omega = s w/(1 + s a cos(tilt) w),    w^2 = (1 - 2 charge2/r)/(2 r^3) of Kerr and Newman,
// the geodesics' at a tilt of 0 and pi, and to first order in a the mean motion of inclined circles between (Wilkins 1972). Their nodes' own
// motion is left to DiscLean::precession. u^t by g(u, u) = -1: at polar angle theta on the plane, c = cos(tilt),
//     1/u_t^2 = 1 - p + 2 a p Omega c - Omega^2 (Sigma (1 - c^2/sin^2) + (r^2 + a^2 + a^2 p sin^2) c^2/sin^2),    p = 2 m(r) r/Sigma.
#pragma once
#include <optional>

#include "spacetime/circular_orbit.h"

namespace nullscope {

// c/r_s. Where nothing rotates, and without a tilt, that of circular_orbit(). Nothing: no such circle there.
std::optional<double> leaning_rate(const Spacetime& spacetime, double r, Sense sense, double tilt);

// 1/u_t^2 of matter with that angular velocity, where its place has this sine of theta; not above 0: it would outrun light. Of a rotating hole.
double leaning_lapse2(const Spacetime& spacetime, double r, double rate, double tilt, double sine);

// The largest radius between two of such a disc at which some of its matter would outrun light, by 400 radii and 32 places on each; nothing:
// none does. Of a rotating hole.
std::optional<double> leaning_disc_limit(const Spacetime& spacetime, double inner, double outer, Sense sense,
                                         double tilt);

}  // namespace nullscope
