#include "reference/scorer.h"

#include <array>
#include <cmath>
#include <limits>

#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/airy.hpp>

#include "reference/chebyshev.h"

namespace nullscope::reference {
namespace {

constexpr double kFar = 10;

// Sums of (3k)!/(k! 3^k) z^(-3k) with factors that belong to each.
Scorer far_scorer(double z) {
    const double cube = z * z * z;
    double term = 1;
    Scorer sum{1, -1, 0};
    for (int k = 1; k < 9; ++k) {
        term *= (3.0 * k - 1) * (3.0 * k - 2) / cube;
        sum.value += term;
        sum.slope -= (3.0 * k + 1) * term;
        sum.beyond += term / (3.0 * k);
    }
    return {sum.value / (M_PI * z), sum.slope / (M_PI * z * z), sum.beyond};
}

std::array<double, 2> near_scorer(double z) {
    namespace math = boost::math;
    static math::quadrature::exp_sinh<double> beyond;
    const double above = beyond.integrate([](double t) { return t < 60 ? math::airy_ai(t) : 0.0; }, z,
                                          std::numeric_limits<double>::infinity(), 1e-10),
                 below =
                     math::quadrature::gauss<double, 30>::integrate([](double t) { return math::airy_bi(t); }, 0.0, z);
    return {math::airy_bi(z) * above + math::airy_ai(z) * below,
            math::airy_bi_prime(z) * above + math::airy_ai_prime(z) * below};
}

}  // namespace

Scorer scorer(double z) {
    if (z > kFar) return far_scorer(z);
    static const ChebyshevPieces<2, 13> pieces(near_scorer, 0, kFar, 10);
    const auto [value, slope] = pieces(z);
    // Integral of pi Gi from z to kFar: half a unit at a time.
    const int panels = static_cast<int>(std::ceil(2 * (kFar - z))) + 1;
    const double width = (kFar - z) / panels;
    double sum = 0;
    for (int i = 0; i < panels; ++i)
        sum += boost::math::quadrature::gauss<double, 10>::integrate([](double t) { return pieces(t)[0]; },
                                                                     z + i * width, z + (i + 1) * width);
    return {value, slope, far_scorer(kFar).beyond + M_PI * sum - std::log(kFar / z)};
}

}  // namespace nullscope::reference
