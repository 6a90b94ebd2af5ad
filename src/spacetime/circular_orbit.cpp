#include "spacetime/circular_orbit.h"

#include <algorithm>
#include <cmath>

namespace nullscope {
namespace {

// d(ln E^2)/dzeta of circular orbits.
double energy_slope(const Spacetime& spacetime, double zeta) {
    const double a = spacetime.lapse_squared(1.0 / zeta), w = spacetime.half_v_slope(zeta);
    const double lapse_slope = 2.0 * (w / zeta - a) / zeta;   // dA/dzeta
    return 2.0 * lapse_slope / a - spacetime.half_v_curvature(zeta) / w + 1.0 / zeta;
}

}  // namespace

std::optional<CircularOrbit> circular_orbit(const Spacetime& spacetime, double r) {
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
    const double zeta = 1.0 / r, a = spacetime.lapse_squared(r), across = last.momentum * zeta;
    const double radial2 = last.energy * last.energy - a * (1.0 + across * across);
    return {last.energy / a, -std::sqrt(std::max(radial2, 0.0)), across * zeta};
}

}  // namespace nullscope
