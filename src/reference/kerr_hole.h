// The numbers of a rotating hole, r_s = 2 M = 1: Delta = r^2 + a^2 - 2 m(r) r with 2 m(r) = 1 - charge2/r, so that
// r_+ + r_- = 1 and r_+ r_- = a^2 + charge2. Without charge Kerr's (1963), with it Kerr and Newman's (1965).
#pragma once
#include <cmath>

namespace nullscope::reference {

struct KerrHole {
    double a, charge2;  // charge2 = (Q/2M)^2

    // a/M and Q/M, whose squares add up to less than 1.
    KerrHole(double spin, double charge = 0) : a(0.5 * spin), charge2(0.25 * charge * charge) {}

    double twice_mass(double r) const { return 1 - charge2 / r; }              // 2 m(r)
    double mass_log_slope(double r) const { return charge2 / (r - charge2); }  // d ln m/d ln r
    double horizons_apart() const { return std::sqrt((1 - 2 * a) * (1 + 2 * a) - 4 * charge2); }
    double outer() const { return 0.5 * (1 + horizons_apart()); }
    double inner() const { return 0.5 * (1 - horizons_apart()); }
    double delta(double r) const { return (r - outer()) * (r - inner()); }
    double horizon_area(double horizon) const { return horizon - charge2; }                // r_h^2 + a^2, over 4 pi
    double g_phiphi(double r) const { return r * r + a * a + a * a * twice_mass(r) / r; }  // in the equatorial plane
};

}  // namespace nullscope::reference
