// The tortoise radius r_*, dr_* = dr/A along radial light, and the clock of what falls.
//
// Light comes in at constant v = t + r_*. What falls through the horizon counts v - r, which is regular there, and far away at rest goes as
// t does. r_* is 1/zeta - ln(zeta) + rho(zeta), rho = 0 far away: with A = (1 - x zeta)(1 - y zeta)
//     r_* = r + (x + y) ln(r - x) + y^2 ln((r - x)/(r - y))/(x - y),
// and about a rotating hole, where A is Delta/(r^2 + a^2),
//     r_* = r + ((r_+ - c) ln(r - r_+) - (r_- - c) ln(r - r_-))/(r_+ - r_-),  c = charge2.
#pragma once
#include "spacetime/spacetime.h"

namespace nullscope {

// r_* - r: by how much v - r is ahead of t. r outside the horizon; 0 where lapse_roots() does not say A. Error: some roundings of ln(r).
double time_ahead(const Spacetime& spacetime, double r);

}  // namespace nullscope
