#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "reference/schwarzschild_delay.h"

namespace nullscope::reference {
namespace {

// Up to this part of |e1| the integrand in zeta itself is analytic in a circle three times as large: 1e-16.
constexpr double kDirectPart = 0.3;
// Panels of this length in the regular variable: the nearest singularity, zeta = e1, lies 0.28 beyond the range at
// least, so that 20 nodes converge as 4^-40.
constexpr double kPanel = 0.5;
using Gauss = boost::math::quadrature::gauss<double, 20>;

template <class Integrand>
double panels(const Integrand& f, double from, double to) {
    const int count = std::max(1, static_cast<int>(std::ceil((to - from) / kPanel)));
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        sum += Gauss::integrate(f, from + (to - from) * i / count, from + (to - from) * (i + 1) / count);
    }
    return sum;
}

// int_0^to dzeta / (sqrt P (q + sqrt P)) for to <= kDirectPart |e1|, where P stays near q^2.
double direct(double q, double to) {
    return Gauss::integrate(
        [q](double zeta) {
            const double root = std::sqrt(q * q - zeta * zeta * (1 - zeta));
            return 1 / (root * (q + root));
        },
        0.0, to);
}

}  // namespace

// e2 - zeta = gap sinh^2(w), e3 - zeta = gap cosh^2(w): dzeta / sqrt((e2-zeta)(e3-zeta)) = -2 dw.
double outward_delay_real(double q, double zeta0, double minus_e1, double e2, double below, double gap) {
    const double split = kDirectPart * minus_e1;
    if (zeta0 <= split) return direct(q, zeta0);
    const double from = std::asinh(std::sqrt(below / gap)), to = std::asinh(std::sqrt((e2 - split) / gap));
    return direct(q, split) + panels(
                                  [=](double w) {
                                      const double sh = std::sinh(w), ch = std::cosh(w),
                                                   first = std::sqrt(e2 - gap * sh * sh + minus_e1);
                                      return 2 / (first * (q + gap * sh * ch * first));
                                  },
                                  from, to);
}

// zeta = re + im sinh(w): dzeta / |zeta - e2| = dw.
double outward_delay_pair(double q, double zeta0, double minus_e1, double re, double im, double beyond) {
    const double split = kDirectPart * minus_e1;
    if (zeta0 <= split) return direct(q, zeta0);
    return direct(q, split) + panels(
                                  [=](double w) {
                                      const double first = std::sqrt(re + im * std::sinh(w) + minus_e1);
                                      return 1 / (first * (q + im * std::cosh(w) * first));
                                  },
                                  std::asinh((split - re) / im), std::asinh(beyond / im));
}

}  // namespace nullscope::reference
