#include "spacetime/circular_orbit.h"

#include <algorithm>
#include <cmath>

namespace nullscope {
namespace {

// d(ln E^2)/dzeta of circular orbits.
double energy_slope(const Spacetime& spacetime, double zeta) {
    const double a = spacetime.lapse_squared(1.0 / zeta), w = spacetime.half_v_slope(zeta);
    const double lapse_slope = 2.0 * (w / zeta - a) / zeta;  // dA/dzeta
    return 2.0 * lapse_slope / a - spacetime.half_v_curvature(zeta) / w + 1.0 / zeta;
}

// Of a spinning hole, in the direction of its spin (Bardeen, Press and Teukolsky 1972, eqs. 2.12 to 2.16, M = 1/2).
std::optional<CircularOrbit> spinning_orbit(double a, double r) {
    const double swirl = a * M_SQRT1_2 / (r * std::sqrt(r)), root2 = 1.0 - 1.5 / r + 2.0 * swirl;
    if (!(root2 > 0.0)) return std::nullopt;
    const double root = std::sqrt(root2);
    CircularOrbit orbit;
    orbit.u_t = (1.0 + swirl) / root;
    orbit.omega = M_SQRT1_2 / (r * std::sqrt(r) * (1.0 + swirl));
    orbit.energy = (1.0 - 1.0 / r + swirl) / root;
    orbit.momentum = std::sqrt(0.5 * r) * (1.0 - 2.0 * swirl + a * a / (r * r)) / root;
    return orbit;
}

// The same, eq. 2.21.
double spinning_stable_orbit(double spin) {
    const double z1 = 1.0 + std::cbrt((1.0 - spin) * (1.0 + spin)) * (std::cbrt(1.0 + spin) + std::cbrt(1.0 - spin));
    const double z2 = std::sqrt(3.0 * spin * spin + z1 * z1);
    return 0.5 * (3.0 + z2 - std::sqrt((3.0 - z1) * (3.0 + z1 + 2.0 * z2)));
}

// Falling with constants e and l in the equatorial plane of a spinning hole.
MatterVelocity spinning_fall(const Spacetime& spacetime, double e, double l, double r) {
    const double a = spacetime.spin(), delta = r * r / spacetime.radial_stretch2(r), x = e * (r * r + a * a) - a * l;
    const double radial2 = x * x - delta * (r * r + (l - a * e) * (l - a * e));
    return {((r * r + a * a + a * a / r) * e - a * l / r) / delta, -std::sqrt(std::max(radial2, 0.0)) / (r * r),
            ((1.0 - 1.0 / r) * l + a * e / r) / delta};
}

}  // namespace

std::optional<CircularOrbit> circular_orbit(const Spacetime& spacetime, double r) {
    if (spacetime.spin() != 0.0) return spinning_orbit(spacetime.spin(), r);
    const double zeta = 1.0 / r, a = spacetime.lapse_squared(r), w = spacetime.half_v_slope(zeta);
    if (!(a > 0.0 && w > 0.0)) return std::nullopt;
    CircularOrbit orbit;
    orbit.u_t = std::sqrt(zeta / w);
    orbit.omega = zeta * std::sqrt(std::max(a - w / zeta, 0.0));
    orbit.energy = a * orbit.u_t;
    orbit.momentum = r * r * orbit.omega * orbit.u_t;
    return orbit;
}

std::optional<double> innermost_stable_orbit(const Spacetime& spacetime) {
    if (spacetime.spin() != 0.0) return spinning_stable_orbit(2.0 * spacetime.spin());
    const auto sphere = spacetime.photon_sphere();
    if (!sphere) return std::nullopt;
    double stable = 1e-6 / sphere->radius, unstable = (1.0 - 1e-9) / sphere->radius;
    while (unstable - stable > 1e-15 * unstable) {
        const double middle = 0.5 * (stable + unstable);
        if (middle <= stable || middle >= unstable) break;
        (energy_slope(spacetime, middle) < 0.0 ? stable : unstable) = middle;
    }
    return 2.0 / (stable + unstable);
}

MatterVelocity disc_matter(const Spacetime& spacetime, double r) {
    const auto isco = innermost_stable_orbit(spacetime);
    if (!isco || r >= *isco) {
        const auto orbit = circular_orbit(spacetime, r);
        return {orbit->u_t, 0.0, orbit->u_t * orbit->omega};
    }
    const CircularOrbit last = *circular_orbit(spacetime, *isco);
    if (spacetime.spin() != 0.0) return spinning_fall(spacetime, last.energy, last.momentum, r);
    const double zeta = 1.0 / r, a = spacetime.lapse_squared(r), across = last.momentum * zeta;
    const double radial2 = last.energy * last.energy - a * (1.0 + across * across);
    return {last.energy / a, -std::sqrt(std::max(radial2, 0.0)), across * zeta};
}

}  // namespace nullscope
