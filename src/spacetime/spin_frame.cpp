#include "spacetime/spin_frame.h"

#include <algorithm>
#include <cmath>

namespace nullscope {

SpinPlace spin_place(const Spacetime& spacetime, double r, double theta) {
    const double a = spacetime.spin(), sine = std::sin(theta), cosine = std::cos(theta);
    return {a,
            r,
            sine,
            cosine,
            (r - *spacetime.horizon_radius()) * (r - inner_horizon(spacetime)),
            r * r + a * a * cosine * cosine,
            r * r + a * a};
}

double inner_horizon(const Spacetime& spacetime) {
    return spacetime.spin() * spacetime.spin() / *spacetime.horizon_radius();
}

double azimuth_ahead(const Spacetime& spacetime, double r) {
    const double outer = *spacetime.horizon_radius(), inner = inner_horizon(spacetime);
    return spacetime.spin() / (outer - inner) * std::log1p(-(outer - inner) / (r - inner));
}

double static_limit(const Spacetime& spacetime, double theta) {
    const double part = 2.0 * spacetime.spin() * std::cos(theta);
    return 0.5 * (1.0 + std::sqrt((1.0 - part) * (1.0 + part)));
}

double zamo_lapse2(const SpinPlace& p) {
    return p.delta * p.sigma / (p.across * p.across - p.delta * p.a * p.a * p.sine * p.sine);
}

SpinFrame carter_frame(const SpinPlace& p) { return {frame_at_rest(p.delta / p.sigma), 0.0}; }

SpinFrame zamo_frame(const SpinPlace& p) {
    return {frame_at_rest(p.delta / p.sigma), -p.a * p.sine * std::sqrt(p.delta) / p.across};
}

std::optional<SpinFrame> static_frame(const SpinPlace& p) {
    const double swirl = -p.a * p.sine / std::sqrt(p.delta);
    if (!(p.delta > 0.0 && swirl > -1.0)) return std::nullopt;
    return SpinFrame{frame_at_rest(p.delta / p.sigma), swirl};
}

// In Carter's frame, without motion along theta, r stays where 2 r Delta (1 + v^2) + 4 r a sin(theta) sqrt(Delta) v = (2 r - 1) Sigma: the
// derivative of (E (r^2 + a^2) - a L)^2 - Delta (r^2 + K) with K = a^2 cos^2 + (L/sin - a E sin)^2, over gamma^2.
std::optional<SpinFrame> orbiting_frame(const SpinPlace& p, bool with_spin) {
    if (!(p.delta > 0.0)) return std::nullopt;
    const double root = std::sqrt(p.delta), half = p.a * p.sine;
    const double under = half * half - p.delta + (1.0 - 0.5 / p.r) * p.sigma;
    if (!(under > 0.0)) return std::nullopt;
    const double swirl = (-half + (with_spin ? 1.0 : -1.0) * std::sqrt(under)) / root;
    if (!(std::fabs(swirl) < 1.0)) return std::nullopt;
    return SpinFrame{frame_at_rest(p.delta / p.sigma), swirl};
}

// Energy E, L = 0, K = a^2 cos^2 + W^2, W = -a E sin: in the frame that has the same radial motion what is left is W along e_3.
SpinFrame falling_frame(const SpinPlace& p, double energy) {
    const double x = energy * p.across, w = -p.a * energy * p.sine, mass2 = p.sigma + w * w;  // r^2 + K
    const double infall = std::sqrt(std::max(x * x - p.delta * mass2, 0.0));
    const double outward = (x + infall) / std::sqrt(p.sigma * mass2);
    return {{outward, p.delta / (p.sigma * outward)}, w / std::sqrt(mass2)};
}

}  // namespace nullscope
