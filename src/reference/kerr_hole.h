// The numbers of a rotating hole, r_s = 2 M = 1: Delta = r^2 + a^2 - 2 m(r) r, m(r) = M, r_+ + r_- = 1. All that a charge
// would change, m = 1/2 - Q^2/(2 r), is here.
#pragma once
#include <cmath>

namespace nullscope::reference {

struct KerrHole {
    double a;

    double twice_mass(double) const { return 1; }      // 2 m(r)
    double mass_log_slope(double) const { return 0; }  // d ln m/d ln r
    double horizons_apart() const { return std::sqrt((1 - 2 * a) * (1 + 2 * a)); }
    double outer() const { return 0.5 * (1 + horizons_apart()); }
    double inner() const { return 0.5 * (1 - horizons_apart()); }
    double delta(double r) const { return (r - outer()) * (r - inner()); }
    double horizon_area(double horizon) const { return twice_mass(horizon) * horizon; }    // r_h^2 + a^2, over 4 pi
    double g_phiphi(double r) const { return r * r + a * a + a * a * twice_mass(r) / r; }  // in the equatorial plane
};

}  // namespace nullscope::reference
