#include "spacetime/janis_newman_winicour.h"

#include <algorithm>
#include <cmath>

namespace nullscope {
namespace {

// (ln(1 + t) - t)/t^2, about -1/2.
double log_rest(double t) {
    if (std::fabs(t) > 0.1) return (std::log1p(t) - t) / (t * t);
    double sum = 0.0, power = 1.0;
    for (int n = 2; n < 20; ++n, power *= -t) sum -= power / n;
    return sum;
}

}  // namespace

JanisNewmanWinicour::JanisNewmanWinicour(double g) : g_(g), r_g_(1.0 / g), x_c_(2.0 / (1.0 + 2.0 * g)) {
    q_crit_ = x_c_ * std::pow(1.0 - x_c_, g_ - 0.5) / r_g_;
    // In tau = -ln y: y keeps its digits, however fast it vanishes with pi - chi.
    constexpr double kLast = 40.0;  // pi - chi is 1e-17 there
    tau_of_ = InverseMap([this](double tau) { return chi_of(-std::expm1(-tau), std::exp(-tau)); }, kLast / (g_ - 0.5));
}

// y = 1 - r_g/r: to the last digit at the surface, finite at infinity.
double JanisNewmanWinicour::rest(double r) const { return r < 2.0 * r_g_ ? (r - r_g_) / r : 1.0 - r_g_ / r; }
double JanisNewmanWinicour::lapse_squared(double r) const { return std::pow(rest(r), g_); }
double JanisNewmanWinicour::areal_radius(double r) const { return r * std::pow(rest(r), 0.5 * (1.0 - g_)); }

double JanisNewmanWinicour::sine(double x, double y) const { return x / x_c_ * std::pow(y / (1.0 - x_c_), g_ - 0.5); }

double JanisNewmanWinicour::cosine_over_gap(double x, double y) const {
    const double a = (x - x_c_) / x_c_, b = (x - x_c_) / (1.0 - x_c_);
    if (!(y > 0.0) || !(a > -1.0)) return 1.0 / std::fabs(a);  // V = 0
    // ln(1 - b) + b; beyond the photon sphere from y, for V falls so slowly with y that y still counts where 1 - b has lost it.
    const double rest_b = b > 0.5 ? std::log(y / (1.0 - x_c_)) + b : b * b * log_rest(-b);
    const double log_ratio = 2.0 * a * a * log_rest(a) + (2.0 * g_ - 1.0) * rest_b;  // ln(V/V_c) <= 0
    if (std::fabs(b) > 0.1) return std::sqrt(-std::expm1(log_ratio)) / std::fabs(a);
    const double stretch = x_c_ / (1.0 - x_c_);                                                    // b/a
    const double over = -2.0 * log_rest(a) - (2.0 * g_ - 1.0) * stretch * stretch * log_rest(-b);  // -L/a^2
    return std::sqrt(over * (log_ratio < 0.0 ? std::expm1(log_ratio) / log_ratio : 1.0));
}

double JanisNewmanWinicour::chi_of(double x, double y) const {
    return std::atan2(sine(x, std::max(y, 0.0)), cosine_over_gap(x, y) * (x_c_ - x) / x_c_);
}

double JanisNewmanWinicour::density_at(double tau) const {
    return std::exp(-0.5 * tau) * cosine_over_gap(-std::expm1(-tau), std::exp(-tau));
}

double JanisNewmanWinicour::chi_from_radius(double r) const {
    require_chi("JanisNewmanWinicour", r, r_g_);
    return chi_of(r_g_ / r, rest(r));
}

double JanisNewmanWinicour::tau_from_chi(double chi) const {
    return tau_of_(
        chi, [this](double tau) { return chi_of(-std::expm1(-tau), std::exp(-tau)); },
        [this](double tau) { return q_crit_ * r_g_ * density_at(tau) * std::exp(g_ * tau); });
}

double JanisNewmanWinicour::radius_from_chi(double chi) const { return r_g_ / -std::expm1(-tau_from_chi(chi)); }
double JanisNewmanWinicour::bending_density(double chi) const { return density_at(tau_from_chi(chi)); }

}  // namespace nullscope
