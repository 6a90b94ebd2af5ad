#include "table/delay_column.h"

#include <cmath>

namespace nullscope {
namespace {

// N, zeta A' and their derivatives, from V/2 alone.
struct Lapse {
    double n, n_slope, za, za_slope;
};

Lapse lapse_at(const SphericalMetric& spacetime, double zeta) {
    if (!(zeta > 0.0)) return {0.0, 0.0, 0.0, 0.0};
    const double a = spacetime.lapse_squared(1.0 / zeta), half_slope = spacetime.orbit_equation()->half_v_slope(zeta);
    const double z2a1 = 2.0 * (half_slope - zeta * a), a1 = z2a1 / (zeta * zeta);
    const double z2a2 = 2.0 * (spacetime.orbit_equation()->half_v_curvature(zeta) - a - 2.0 * zeta * a1);
    return {1.0 - a * (1.0 + zeta) - 0.5 * z2a1, -a1 * (1.0 + zeta) - a - zeta * a1 - 0.5 * z2a2, zeta * a1,
            a1 + z2a2 / zeta};
}

// dD/dphi, and its derivatives by phi and, at fixed phi, by delta.
struct Rate {
    double value, by_phi, by_delta;
};

struct Ray {
    double q, q_per_delta, sigma;
};

Rate rate_at(const SphericalMetric& spacetime, const Ray& ray, const OrbitState& s) {
    const Lapse lapse = lapse_at(spacetime, s.at);
    // q - sigma zeta': where it is small, V over the sum.
    const double sum = ray.q + ray.sigma * s.slope;
    const double v = s.at > 0.0 ? s.at * s.at * spacetime.lapse_squared(1.0 / s.at) : 0.0;
    const double rest = ray.sigma * s.slope > 0.0 ? v / sum : ray.q - ray.sigma * s.slope;
    if (!(rest > 0.0)) return {0.0, 0.0, 0.0};  // the sky itself, on a ray that has come from it
    const double first = lapse.n / rest, bend = -spacetime.orbit_equation()->half_v_slope(s.at);
    const auto along = [&](double zeta, double slope, double q) {
        return (lapse.n_slope * zeta - first * (q - ray.sigma * slope)) / rest -
               (lapse.za_slope * zeta - lapse.za * q / ray.q) / (2.0 * ray.q);
    };
    return {first - lapse.za / (2.0 * ray.q), along(s.slope, bend, 0.0), along(s.vary, s.vary_slope, ray.q_per_delta)};
}

// Quintic Hermite polynomial through value, slope and curvature at 0 and h: value and slope at f h.
std::array<double, 2> quintic(double f, double h, std::array<double, 3> low, std::array<double, 3> high) {
    const double b1 = h * low[1], c1 = h * h * low[2], b2 = h * high[1], c2 = h * h * high[2], d = high[0] - low[0];
    const double k3 = 10 * d - 6 * b1 - 4 * b2 - 1.5 * c1 + 0.5 * c2, k4 = -15 * d + 8 * b1 + 7 * b2 + 1.5 * c1 - c2,
                 k5 = 6 * d - 3 * (b1 + b2) - 0.5 * (c1 - c2);
    return {low[0] + f * (b1 + f * (0.5 * c1 + f * (k3 + f * (k4 + f * k5)))),
            (b1 + f * (c1 + f * (3 * k3 + f * (4 * k4 + f * 5 * k5)))) / h};
}

OrbitState between(const SphericalMetric& spacetime, const OrbitState& low, const OrbitState& high, double f,
                   double h) {
    const auto bend = [&](const OrbitState& s) { return -spacetime.orbit_equation()->half_v_slope(s.at); };
    const auto vary = [&](const OrbitState& s) { return -spacetime.orbit_equation()->half_v_curvature(s.at) * s.vary; };
    const auto place = quintic(f, h, {low.at, low.slope, bend(low)}, {high.at, high.slope, bend(high)});
    const auto moved = quintic(f, h, {low.vary, low.vary_slope, vary(low)}, {high.vary, high.vary_slope, vary(high)});
    return {place[0], place[1], moved[0], moved[1]};
}

}  // namespace

OrbitTexels delay_column(const RayFamily& family, Segment segment, const FanRay& family_ray, const MetOrbit& met) {
    const SphericalMetric& spacetime = family.spacetime();
    const auto& orbit = met.states;
    const double side = segment == Segment::kSky ? 1.0 : -1.0;
    const Ray ray{family_ray.q, -family_ray.slope / family_ray.sin_beta * side, side};
    const std::size_t rows = orbit.size() - 1;
    const double cell = family_ray.phi_end / static_cast<double>(rows);
    // Lobatto's rule of four points.
    const double inner = 0.5 - 0.1 * std::sqrt(5.0);
    OrbitTexels column(rows + 1);
    double sum = 0.0, sum_delta = 0.0;
    Rate low = rate_at(spacetime, ray, orbit[0]);
    for (std::size_t i = 0;; ++i) {
        const double v = static_cast<double>(i) / static_cast<double>(rows), moved = v * met.end_per_delta;
        column[i] = {
            sum, sum_delta + low.value * moved, low.value * cell,
            (low.by_delta + low.by_phi * moved) * cell + low.value * met.end_per_delta / static_cast<double>(rows)};
        if (i == rows) return column;
        const Rate high = rate_at(spacetime, ray, orbit[i + 1]);
        const Rate a = rate_at(spacetime, ray, between(spacetime, orbit[i], orbit[i + 1], inner, cell));
        const Rate b = rate_at(spacetime, ray, between(spacetime, orbit[i], orbit[i + 1], 1.0 - inner, cell));
        sum += cell / 12.0 * (low.value + high.value + 5.0 * (a.value + b.value));
        sum_delta += cell / 12.0 * (low.by_delta + high.by_delta + 5.0 * (a.by_delta + b.by_delta));
        low = high;
    }
}

}  // namespace nullscope
