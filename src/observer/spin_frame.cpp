#include "observer/spin_frame.h"

#include <algorithm>
#include <cmath>

namespace nullscope {

SpinPlace spin_place(const AxialMetric& metric, double r, double theta) {
    const double a = metric.a(), sine = std::sin(theta), cosine = std::cos(theta);
    return {a, r, sine, cosine, metric.delta(r), r * r + a * a * cosine * cosine, r * r + a * a, metric.two_mass(r)};
}

// Where Delta = a^2 sin^2(theta).
double static_limit(const AxialMetric& metric, double theta) {
    const double part = 2.0 * metric.a() * std::cos(theta);
    return 0.5 * (1.0 + std::sqrt((1.0 - part) * (1.0 + part) - 4.0 * metric.charge2()));
}

double zamo_lapse2(const SpinPlace& p) {
    return p.delta * p.sigma / (p.across * p.across - p.delta * p.a * p.a * p.sine * p.sine);
}

SpinFrame carter_frame(const SpinPlace& p) { return {frame_at_rest(p.delta / p.sigma), 0.0}; }

SpinFrame zamo_frame(const SpinPlace& p) {
    return {frame_at_rest(p.delta / p.sigma), -p.a * p.sine * std::sqrt(p.delta) / p.across};
}

std::optional<SpinFrame> static_frame(const SpinPlace& p) {
    const double azimuthal_velocity = -p.a * p.sine / std::sqrt(p.delta);
    if (!(p.delta > 0.0 && azimuthal_velocity > -1.0)) return std::nullopt;
    return SpinFrame{frame_at_rest(p.delta / p.sigma), azimuthal_velocity};
}

// In Carter's frame, without motion along theta, r stays where 2 r Delta (1 + v^2) + 4 r a sin(theta) sqrt(Delta) v = (2 r - 1) Sigma, 2 r - 1 = Delta': the
// derivative of (E (r^2 + a^2) - a L)^2 - Delta (r^2 + K) with K = a^2 cos^2 + (L/sin - a E sin)^2, over gamma^2.
std::optional<SpinFrame> orbiting_frame(const SpinPlace& p, bool eastward) {
    if (!(p.delta > 0.0)) return std::nullopt;
    const double root = std::sqrt(p.delta), half = p.a * p.sine;
    const double under = half * half - p.delta + (1.0 - 0.5 / p.r) * p.sigma;
    if (!(under > 0.0)) return std::nullopt;
    const double azimuthal_velocity = (-half + (eastward ? 1.0 : -1.0) * std::sqrt(under)) / root;
    if (!(std::fabs(azimuthal_velocity) < 1.0)) return std::nullopt;
    return SpinFrame{frame_at_rest(p.delta / p.sigma), azimuthal_velocity};
}

// Energy E, L = 0, K = a^2 cos^2 + W^2, W = -a E sin: in the frame that has the same radial motion what is left is W along e_3.
SpinFrame falling_frame(const SpinPlace& p, double energy) {
    const double x = energy * p.across, w = -p.a * energy * p.sine, mass2 = p.sigma + w * w;  // r^2 + K
    const double infall = std::sqrt(std::max(x * x - p.delta * mass2, 0.0));
    const double outward = (x + infall) / std::sqrt(p.sigma * mass2);
    return {{outward, p.delta / (p.sigma * outward)}, w / std::sqrt(mass2)};
}

}  // namespace nullscope
