#include "spacetime/axial_metric.h"

#include <cmath>

namespace nullscope {
namespace {

double horizons_apart(double spin, double charge) {
    const double square = (1.0 - spin) * (1.0 + spin) - charge * charge;
    return std::fmax(std::sqrt(std::fmax(square, 0.0)), AxialMetric::kLeastApart);
}

}  // namespace

AxialMetric::AxialMetric(std::string_view name, double spin, double charge)
    : name_(name),
      a_(0.5 * spin),
      charge2_(0.25 * charge * charge),
      outer_(0.5 * (1.0 + horizons_apart(spin, charge))),
      inner_((a_ * a_ + charge2_) / outer_) {}

double AxialMetric::lapse_squared(double r) const {
    const double zeta = 1.0 / r, a2 = a_ * a_ * zeta * zeta;  // by zeta, for r = infinity too
    return (1.0 - outer_ * zeta) * (1.0 - inner_ * zeta) / (1.0 + a2 * (1.0 + zeta * two_mass(r)));
}

double AxialMetric::azimuth_ahead(double r) const {
    const double gap = outer_ - inner_;
    return a_ / gap * std::log1p(-gap / (r - inner_));
}

Matrix4 AxialMetric::metric(double r, double theta) const {
    const double sine2 = std::pow(std::sin(theta), 2), sigma = r * r + a_ * a_ * std::pow(std::cos(theta), 2),
                 pull = two_mass(r) * r / sigma;
    Matrix4 g{};
    g[0][0] = -(1.0 - pull);
    g[0][3] = g[3][0] = -a_ * pull * sine2;
    g[1][1] = sigma / delta(r);
    g[2][2] = sigma;
    g[3][3] = (r * r + a_ * a_ + a_ * a_ * pull * sine2) * sine2;
    return g;
}

Matrix4 AxialMetric::inverse_metric(double r, double theta) const {
    const double sine2 = std::pow(std::sin(theta), 2), sigma = r * r + a_ * a_ * std::pow(std::cos(theta), 2),
                 pull = two_mass(r) * r / sigma, d = delta(r);
    Matrix4 g{};
    g[0][0] = -(r * r + a_ * a_ + a_ * a_ * pull * sine2) / d;
    g[0][3] = g[3][0] = -a_ * pull / d;
    g[1][1] = d / sigma;
    g[2][2] = 1.0 / sigma;
    g[3][3] = (1.0 - pull) / (d * sine2);
    return g;
}

// With f = 2 m(r)/r = zeta - charge2 zeta^2: g_tt = f - 1, g_tphi = -a f, g_phiphi = r^2 + a^2 (1 + f), and
// g_tphi^2 - g_tt g_phiphi = Delta.
std::optional<Equator> AxialMetric::equator(double r) const {
    const double zeta = 1.0 / r, z2 = zeta * zeta, a2 = a_ * a_, f = zeta * two_mass(r),
                 first = z2 * (2.0 * charge2_ * zeta - 1.0), second = z2 * zeta * (2.0 - 6.0 * charge2_ * zeta);
    return Equator{{f - 1.0, -a_ * f, r * r + a2 * (1.0 + f)},
                   {first, -a_ * first, 2.0 * r + a2 * first},
                   {second, -a_ * second, 2.0 + a2 * second},
                   delta(r),
                   r * r};
}

}  // namespace nullscope
