#include "observer/spin_forms.h"

#include <cmath>

#include "base/rounding.h"

namespace nullscope {

// The photon has (1, -n) along the camera's frame and (gamma (1 - v n_phi), -n_r, -n_theta, gamma (v - n_phi)) = (k0, k1, k2, k3) along the one
// that it moves in. There E = energy k0 - infall k1 + (a sin/root) k3, L/sin - a E sin = root k3, p_theta = root k2 and
// Sigma dr/dlambda = Sigma (energy k1 - infall k0), root = sqrt(Sigma).
SpinForms spin_forms(const SpinPlace& p, const SpinFrame& frame) {
    const double v = frame.azimuthal_velocity, gamma = 1.0 / std::sqrt((1.0 - v) * (1.0 + v)),
                 root = std::sqrt(p.sigma);
    const double energy = frame.radial.energy(), infall = frame.radial.infall(), drag = p.a * p.sine,
                 girth = p.across / root;
    const double scale = p.sigma / (p.r * p.r);
    SpinForms forms;
    forms.energy = {-gamma * (energy + drag / root * v), -infall, gamma * (energy * v + drag / root)};
    const double turning = without_rounding(drag * energy + girth * v, girth);  // 0 without angular momentum
    forms.across = {-gamma * turning, -drag * infall, gamma * (drag * energy * v + girth)};
    forms.climb = {-scale * gamma * infall, -scale * energy, scale * gamma * infall * v};
    forms.carter = -gamma * root * v;
    forms.carter_slope = gamma * root;
    forms.p_theta = root;
    return forms;
}

// X = E (r^2 + a^2) - a L = Sigma (energy k0 - infall k1) at the camera, less E (r^2 - r_+^2).
SpinForm horizon_form(const AxialMetric& metric, const SpinPlace& p, const SpinFrame& frame) {
    const double v = frame.azimuthal_velocity, gamma = 1.0 / std::sqrt((1.0 - v) * (1.0 + v)),
                 outer = metric.outer_horizon(), rise = (p.r - outer) * (p.r + outer);
    const double energy = p.sigma * gamma * frame.radial.energy(), infall = p.sigma * frame.radial.infall();
    const SpinForm tangent = spin_forms(p, frame).energy;
    const auto over = [&](double x) { return x / (outer * outer); };
    return {over(energy + rise * tangent.constant), over(infall + rise * tangent.radial),
            over(rise * tangent.around - energy * v)};
}

bool is_next_to_horizon(const Spacetime& spacetime, double r) {
    constexpr double kNext = 0.6;
    return std::fabs(1.0 - *spacetime.horizon_radius() / r) < kNext;
}

}  // namespace nullscope
