#include "reference/elliptic.h"

#include <array>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <cmath>
#include <complex>

namespace nullscope::reference {
namespace {

namespace policies = boost::math::policies;
using Quiet =
    policies::policy<policies::domain_error<policies::ignore_error>, policies::pole_error<policies::ignore_error>,
                     policies::overflow_error<policies::ignore_error>,
                     policies::evaluation_error<policies::ignore_error>, policies::promote_double<false>>;

// Below this relative spread of the arguments the series of R_F, cut after its terms of order 5, is good to 1e-17.
constexpr double kSeriesSpread = 2e-3;
// The arithmetic-geometric mean squares its relative gap at each step: 1e-9 before the last step is 1e-18 after it.
constexpr double kMeanGap = 1e-9;

}  // namespace

double rf(double x, double y, double z) { return boost::math::ellint_rf(x, y, z, Quiet()); }
double rd(double x, double y, double z) { return boost::math::ellint_rd(x, y, z, Quiet()); }
double rj(double x, double y, double z, double p) { return boost::math::ellint_rj(x, y, z, p, Quiet()); }

// Duplication (Carlson 1995, Numer. Algorithms 10, 13): R_F(x, y, z) = R_F((x+l)/4, (y+l)/4, (z+l)/4) with
// l = sqrt(x)sqrt(y) + sqrt(x)sqrt(z) + sqrt(y)sqrt(z), for z = conj(y): l = 2 sqrt(x) Re sqrt(y) + |y|, real.
// First step: y + l = u^2 + 2 w re + |u|^2 = 2 re (re + w + i im).
double rf_pair(double w, double re, double im) {
    double x = 0.25 * (w * w + 2 * w * re + re * re + im * im);
    std::complex<double> y = 0.5 * re * std::complex<double>(re + w, im);
    for (;;) {
        const double mean = (x + 2 * y.real()) / 3;
        const double dx = (mean - x) / mean;
        const std::complex<double> dy = (mean - y) / mean;
        if (!(std::abs(dx) >= kSeriesSpread || std::abs(dy) >= kSeriesSpread)) {  // also for what is not a number
            const double e2 = std::norm(dy) - dx * dx;                            // x (y + z) + y z with x + y + z = 0
            const double e3 = dx * std::norm(dy);
            return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / std::sqrt(mean);
        }
        const double lambda = 2 * std::sqrt(x) * std::sqrt(y).real() + std::abs(y);
        x = 0.25 * (x + lambda);
        y = 0.25 * (y + lambda);
    }
}

Jacobi::Jacobi(double m1) {
    double a = 1, square = m1;
    while (steps_ < kMeanSteps) {
        const double b = std::sqrt(square);
        upper_[steps_] = a;
        lower_[steps_] = b;
        ++steps_;
        mean_ = 0.5 * (a + b);
        if (std::abs(a - b) <= kMeanGap * a) break;
        square = a * b;
        a = mean_;
    }
}

JacobiValues Jacobi::operator()(double z) const {
    const double sine = std::sin(mean_ * z);
    if (sine == 0) return {0, 1, 1};
    // Back from the mean: Gauss' transformation for c = a cot(amplitude), which keeps cn relative near K.
    double ratio = std::cos(mean_ * z) / sine, c = mean_ * ratio, dn = 1;
    for (int i = steps_ - 1; i >= 0; --i) {
        ratio *= c;
        c *= dn;
        dn = (lower_[i] + ratio) / (upper_[i] + ratio);
        ratio = c / upper_[i];
    }
    const double sn = std::copysign(1 / std::hypot(c, 1.0), sine);
    return {sn, c * sn, dn};
}

}  // namespace nullscope::reference
