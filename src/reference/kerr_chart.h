// Cartesian Kerr-Schild coordinates, g = eta + 2 H l l with l = (1, lx, ly, lz), regular where matter falls in:
//     x + iy = (r + ia) sin(theta) e^{i phi~},  z = r cos(theta),  2 H = 2 m r^3/(r^4 + a^2 z^2),
//     l = (1, (r x + a y)/(r^2 + a^2), (r y - a x)/(r^2 + a^2), z/r).
#pragma once
#include <cmath>

#include "base/vec.h"

namespace nullscope::reference {

// The numbers of a rotating hole, r_s = 2 M = 1: Delta = r^2 + a^2 - 2 m(r) r with 2 m(r) = 1 - charge2/r, so that
// r_+ + r_- = 1 and r_+ r_- = a^2 + charge2. Without charge Kerr's (1963), with it Kerr and Newman's (1965).
struct KerrHole {
    double a, charge2;  // charge2 = (Q/2M)^2

    // a/M and Q/M, whose squares add up to 1 at most.
    KerrHole(double spin, double charge = 0) : a(0.5 * spin), charge2(0.25 * charge * charge) {}

    double twice_mass(double r) const { return 1 - charge2 / r; }              // 2 m(r)
    double mass_log_slope(double r) const { return charge2 / (r - charge2); }  // d ln m/d ln r
    double horizons_apart() const { return std::sqrt(std::fmax((1 - 2 * a) * (1 + 2 * a) - 4 * charge2, 0.0)); }
    double outer() const { return 0.5 * (1 + horizons_apart()); }
    double inner() const { return 0.5 * (1 - horizons_apart()); }
    double delta(double r) const { return (r - outer()) * (r - inner()); }
    double horizon_area(double horizon) const { return horizon - charge2; }                // r_h^2 + a^2, over 4 pi
    double g_phiphi(double r) const { return r * r + a * a + a * a * twice_mass(r) / r; }  // in the equatorial plane
};

struct KerrChart : KerrHole {
    double radius(const Vec3& x) const {
        const double flat = dot(x, x) - a * a, az = a * x.z, root = std::sqrt(flat * flat + 4 * az * az);
        // The larger root of r^4 - flat r^2 - a^2 z^2 = 0, without a difference.
        return std::sqrt(flat > 0 ? 0.5 * (flat + root) : 2 * az * az / (root - flat));
    }
    double rising(const Vec3& x, const Vec3& velocity) const {  // dr/dlambda
        const double r = radius(x), r2 = r * r, sum = r2 * r2 + a * a * x.z * x.z;
        return (x.x * velocity.x + x.y * velocity.y) * r2 * r / sum + x.z * velocity.z * r * (r2 + a * a) / sum;
    }

    // Of a photon with p_t = -energy and momentum p, by Hamilton's equations of H = (eta^{mu nu} p p - 2 H (l p)^2)/2.
    struct Pull {
        Vec3 drift;    // dx/dlambda - p = -2 H (l p) l
        Vec3 force;    // dp/dlambda
        double delay;  // dt/dlambda - energy = 2 H l p
        double lp;
    };
    Pull pull(double energy, const Vec3& x, const Vec3& p) const {
        const double r = radius(x), r2 = r * r, across = r2 + a * a;
        const double sum = r2 * r2 + a * a * x.z * x.z, h = 0.5 * twice_mass(r) * r2 * r / sum,
                     power = 3 + mass_log_slope(r);
        const double lx = (r * x.x + a * x.y) / across, ly = (r * x.y - a * x.x) / across, lz = x.z / r;
        const double lp = energy + lx * p.x + ly * p.y + lz * p.z, part = 2 * h * lp;
        const double place[3]{x.x, x.y, x.z};
        double force[3];
        for (int i = 0; i < 3; ++i) {
            const double dr = i == 2 ? x.z * r * across / sum : place[i] * r2 * r / sum;
            const double dsum = 4 * r2 * r * dr + (i == 2 ? 2 * a * a * x.z : 0.0);
            const double dh = h * (power * dr / r - dsum / sum);
            const double dlx = ((dr * x.x + (i == 0 ? r : i == 1 ? a : 0.0)) - lx * 2 * r * dr) / across;
            const double dly = ((dr * x.y + (i == 1 ? r : i == 0 ? -a : 0.0)) - ly * 2 * r * dr) / across;
            const double dlz = ((i == 2 ? 1.0 : 0.0) - lz * dr) / r;
            force[i] = dh * lp * lp + part * (dlx * p.x + dly * p.y + dlz * p.z);
        }
        return {{-part * lx, -part * ly, -part * lz}, {force[0], force[1], force[2]}, part, lp};
    }

    // What the azimuth of x + iy = (r + ia) sin(theta) e^{i phi~} is ahead of Boyer and Lindquist's, which it meets at
    // infinity.
    double ahead(double r) const { return std::atan2(a, r) + drag_ahead(r); }
    double drag_ahead(double r) const { return a * delta_ahead(r); }  // of phi~
    double tortoise_ahead(double r) const {                           // r_* - r
        return std::log(r) + std::log1p(-outer() / r) + horizon_area(inner()) * delta_ahead(r);
    }
    double ahead_slope(double r) const { return a * (1 / delta(r) - 1 / (r * r + a * a)); }
    double tortoise_slope(double r) const { return twice_mass(r) * r / delta(r); }  // of tortoise_ahead
    double delta_ahead(
        double r) const {  // less the integral of dr/Delta from here on, also where both horizons are one
        const double root = horizons_apart(), open = r - inner();
        return root > 0 ? std::log1p(-root / open) / root : -1 / open;
    }
};

}  // namespace nullscope::reference
