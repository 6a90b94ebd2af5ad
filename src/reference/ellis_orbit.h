// Ellis wormhole orbits in closed form: (dl/dphi)^2 = (l^2 + 1)(l^2 + 1 - b^2)/b^2, lengths in throat radii (scaled by the throat's
// radius where that is not 1), q = 1/b.
//
// b > 1: the ray turns. With alpha the angle from the outward radial direction on its own side, sin(alpha) = b/sqrt(l^2 + 1):
//     phi = F(alpha | 1/b^2) counted from that side's sky, 2 K(1/b^2) in all.
// b < 1: it passes the throat. With sin(psi) = 1/sqrt(l^2 + 1), psi from 0 (l = +infinity) to pi (l = -infinity):
//     phi = b F(psi | b^2), 2 b K(b^2) in all.
#pragma once
#include <memory>

#include "reference/orbit.h"

namespace nullscope::reference {

std::unique_ptr<OrbitMetric> make_ellis_orbits(const SpacetimeSpec& spec);

}  // namespace nullscope::reference
