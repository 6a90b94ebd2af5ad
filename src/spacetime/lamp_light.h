// What a lamp on the axis of a thin disc sends to each of its rings: the lamp post of X-ray astronomy.
//
// Rays from the axis have no angular momentum: K = Carter's constant + a^2 is all that tells them apart. A lamp at rest at height h sends
// them at the angle delta from the way inward, sin(delta)^2 = K (-g_tt)/(h^2 + a^2) with g_tt of the lamp. With
// zeta = 1/r and Mino's time they reach the plane after pi/(2 AGM(sqrt(K), sqrt(K - a^2))). Of what is sent alike in all directions a ring gets, by
// its own time and area (r dt dr dphi is the volume of the plane in spacetime, whoever measures it),
//     sin(delta) |d(delta)/dr|/(r u^t(lamp))  photons,
// and if they are spread as E^-index, those above an energy are G^(index - 1) as many, G the energy in the matter over that in the lamp
// (Fukumura and Kazanas, Astrophys. J. 664, 14 (2007); Dauser et al., Mon. Not. R. Astron. Soc. 430, 1694 (2013), whose area and
// Lorentz factor come to the same). index 2: the energy that arrives. In flat space: h/(h^2 + r^2)^(3/2).
#pragma once
#include <vector>

#include "spacetime/circular_orbit.h"
#include "spacetime/spacetime.h"

namespace nullscope {

struct LampPost {
    double height = 5.0;  // r_s: the radial coordinate on the axis, outside of the horizon
    double index = 2.0;   // photon index of its spectrum
    friend bool operator==(const LampPost&, const LampPost&) = default;
};

// At each radius (r_s, any order, outside the horizon), per lamp of unit strength, 1/r_s^2. 0 where no ray comes directly. Relative error below 1e-7; 10
// microseconds a radius, of metrics by formula 100. The spacetime: one that can have a disc (can_have_disc()).
std::vector<double> lamp_light(const Spacetime& spacetime, const std::vector<double>& radii, const LampPost& lamp,
                               Sense sense = Sense::kEastward);

}  // namespace nullscope
