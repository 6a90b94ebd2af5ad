#include "spacetime/reissner_nordstrom.h"

#include <algorithm>
#include <cmath>

namespace nullscope {

namespace {
constexpr double kNear = 2.0;  // r_s; 1 - r_o/r loses no digit from there on
}

ReissnerNordstrom::ReissnerNordstrom(double charge) : kappa_(0.25 * charge * charge) {
    const double s = std::sqrt((1.0 - charge) * (1.0 + charge)), d = std::sqrt(1.0 + 8.0 * s * s);
    outer_ = 0.5 * (1.0 + s);
    inner_ = kappa_ / outer_;
    sphere_ = 0.25 * (3.0 + d);
    zeta_c_ = 1.0 / sphere_;
    q_crit_ = 0.5 * zeta_c_ * std::sqrt(2.0 - zeta_c_);
    gap_ = 0.5 * s * (1.0 + 4.0 * s / (1.0 + d));
    const double middle = sphere_ - 0.5, low = 0.25 * (2.0 - zeta_c_);
    innermost_ = 2.0 * kappa_ / (middle + std::sqrt(middle * middle + 4.0 * kappa_ * low));
    zeta_of_ = InverseMap([this](double zeta) { return chi_of(zeta, outside(zeta)); }, 1.0 / outer_);
}

double ReissnerNordstrom::chi_of(double zeta, double outside) const {
    const double g = 0.25 * (2.0 - zeta_c_) + zeta * ((sphere_ - 0.5) - kappa_ * zeta);
    return std::atan2(zeta * std::sqrt(outside * (1.0 - inner_ * zeta)), (zeta_c_ - zeta) * std::sqrt(g));
}

// 1 - r_o/r: to the last digit at the horizon, finite at infinity.
double ReissnerNordstrom::outside_of(double r) const { return r < kNear ? (r - outer_) / r : 1.0 - outer_ / r; }

// 1 - r_o zeta; a rounding below zero on the horizon itself.
double ReissnerNordstrom::outside(double zeta) const { return std::max(1.0 - outer_ * zeta, 0.0); }

double ReissnerNordstrom::density_at(double zeta) const {
    const double out = outside(zeta), stable = out + gap_ * zeta;
    const double g = 0.25 * (2.0 - zeta_c_) + zeta * ((sphere_ - 0.5) - kappa_ * zeta);
    // sqrt(A)/(1 - r_u zeta); on the extremal horizon both vanish alike.
    const double ratio = stable > 0.0 ? std::sqrt(out * (1.0 - inner_ * zeta)) / stable : 1.0;
    return std::sqrt(g) / (q_crit_ * sphere_) * ratio;
}

double ReissnerNordstrom::chi_from_radius(double r) const {
    require_chi("ReissnerNordstrom", r, outer_);
    return chi_of(1.0 / r, outside_of(r));
}

double ReissnerNordstrom::zeta_from_chi(double chi) const {
    return zeta_of_(
        chi, [this](double zeta) { return chi_of(zeta, outside(zeta)); },
        [this](double zeta) { return q_crit_ * density_at(zeta); });
}

double ReissnerNordstrom::radius_from_chi(double chi) const { return 1.0 / zeta_from_chi(chi); }

double ReissnerNordstrom::bending_density(double chi) const { return density_at(zeta_from_chi(chi)); }

double ReissnerNordstrom::lapse_squared(double r) const { return outside_of(r) * (1.0 - inner_ / r); }

}  // namespace nullscope
