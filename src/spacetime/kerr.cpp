#include "spacetime/kerr.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "spacetime/schwarzschild.h"

namespace nullscope {
namespace {

[[noreturn]] void no_planes(const char* function, double argument) {
    std::fprintf(stderr, "Kerr::%s(%.17g): no ray stays in a plane\n", function, argument);
    std::abort();
}

}  // namespace

double Kerr::chi_from_radius(double r) const { no_planes("chi_from_radius", r); }
double Kerr::radius_from_chi(double chi) const { no_planes("radius_from_chi", chi); }
double Kerr::bending_density(double chi) const { no_planes("bending_density", chi); }
double Kerr::half_v_slope(double zeta) const { no_planes("half_v_slope", zeta); }
double Kerr::half_v_curvature(double zeta) const { no_planes("half_v_curvature", zeta); }

Kerr::Kerr(double spin_over_mass)
    : a_(0.5 * spin_over_mass), outer_(0.5 * (1.0 + std::sqrt((1.0 - spin_over_mass) * (1.0 + spin_over_mass)))) {}

double Kerr::lapse_squared(double r) const {
    const double zeta = 1.0 / r, a2 = a_ * a_ * zeta * zeta;  // by zeta, for r = infinity too
    return (1.0 - outer_ * zeta) * (1.0 - inner_horizon() * zeta) / (1.0 + a2 * (1.0 + zeta));
}

Matrix4 Kerr::metric(double r, double theta) const {
    const double sine2 = std::pow(std::sin(theta), 2), sigma = r * r + a_ * a_ * std::pow(std::cos(theta), 2);
    Matrix4 g{};
    g[0][0] = -(1.0 - r / sigma);
    g[0][3] = g[3][0] = -a_ * r * sine2 / sigma;
    g[1][1] = sigma / delta(r);
    g[2][2] = sigma;
    g[3][3] = (r * r + a_ * a_ + a_ * a_ * r * sine2 / sigma) * sine2;
    return g;
}

Matrix4 Kerr::inverse_metric(double r, double theta) const {
    const double sine2 = std::pow(std::sin(theta), 2), sigma = r * r + a_ * a_ * std::pow(std::cos(theta), 2),
                 d = delta(r);
    Matrix4 g{};
    g[0][0] = -(r * r + a_ * a_ + a_ * a_ * r * sine2 / sigma) / d;
    g[0][3] = g[3][0] = -a_ * r / (sigma * d);
    g[1][1] = d / sigma;
    g[2][2] = 1.0 / sigma;
    g[3][3] = (1.0 - r / sigma) / (d * sine2);
    return g;
}

std::unique_ptr<Spacetime> make_kerr(const std::map<std::string, double>& parameters) {
    const double spin = parameters.at("spin");
    if (spin == 0.0) return make_schwarzschild({});
    return std::make_unique<Kerr>(spin);
}

}  // namespace nullscope
