#include "reference/synchrotron_integrals.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>

#include "reference/chebyshev.h"
#include "reference/scorer.h"

namespace nullscope::reference {
namespace {

constexpr double kLeast = 1e-12, kMost = 600;  // x
enum { kI, kQ, kV, kConvert, kTurn, kKernels };
using Kernels = std::array<double, kKernels>;

double bessel_beyond(double order, double x) {
    static boost::math::quadrature::exp_sinh<double> rule;
    return rule.integrate([&](double t) { return t < 700 ? boost::math::cyl_bessel_k(order, t) : 0.0; }, x,
                          std::numeric_limits<double>::infinity(), 1e-9);
}

// Logarithms of those of light; that of conversion over sqrt(z).
Kernels kernels_at(double x) {
    const double z = std::cbrt(2.25 * x * x);
    const Scorer s = scorer(z);
    return {std::log(x * bessel_beyond(5.0 / 3, x)), std::log(x * boost::math::cyl_bessel_k(2.0 / 3, x)),
            std::log(x * boost::math::cyl_bessel_k(1.0 / 3, x) + bessel_beyond(1.0 / 3, x)), -M_PI * s.slope,
            0.5 * (2.0 / 3 * (M_PI * z * s.value - 1) + s.beyond)};
}

// x up to kMost; below kLeast as at the lowest frequencies, to 1e-8.
Kernels kernels(double x) {
    constexpr std::size_t kPieces = 36;
    static const ChebyshevPieces<kKernels, 13> pieces([](double log_x) { return kernels_at(std::exp(log_x)); },
                                                      std::log(kLeast), std::log(kMost), kPieces);
    const double log_x = std::log(x), below = std::min(log_x - std::log(kLeast), 0.0);
    auto k = pieces(std::clamp(log_x, std::log(kLeast), std::log(kMost)));
    k[kI] = std::exp(k[kI] + below / 3), k[kQ] = std::exp(k[kQ] + below / 3), k[kV] = std::exp(k[kV]);
    k[kConvert] *= std::cbrt(1.5 * x);  // sqrt(z)
    k[kTurn] += below / 3;
    return k;
}

// Mean over a field of every direction of that of I, with the sine: x is that across the field.
double mean_kernel(double x) {
    static const ChebyshevPieces<1, 13> pieces(
        [](double log_x) {
            const double across = std::exp(log_x);
            double sum = 0;
            for (int i = 0; i < 8; ++i)
                sum += boost::math::quadrature::gauss<double, 30>::integrate(
                    [&](double angle) {
                        const double sine = std::sin(angle), at = across / sine;
                        return at < kMost ? sine * sine * kernels(at)[kI] : 0.0;
                    },
                    M_PI / 16 * i, M_PI / 16 * (i + 1));
            return std::array{std::log(sum)};
        },
        std::log(kLeast), std::log(0.9 * kMost), 36);
    const double log_x = std::log(x), below = std::min(log_x - std::log(kLeast), 0.0);
    if (x > 0.9 * kMost) return 0;
    return std::exp(pieces(log_x - below)[0] + below / 3);
}

Kernels kernels_or_mean(double x, bool isotropic) {
    if (x > kMost) return {0, 0, 0, 1 / (1.5 * x), 0};
    if (!isotropic) return kernels(x);
    return {mean_kernel(x), 0, 0, 0, 0};
}

// Of a distribution, by ln u: u^3 f, and -u^4 df/du.
struct Number {
    double there, falls;
};
Number number_at(const ElectronSpec& e, double u) {
    if (e.kind == ElectronKind::kKappa) {
        const double there = u * u * u * std::pow(1 + u, -e.kappa - 1);
        return {there, there * (e.kappa + 1) * u / (1 + u)};
    }
    const double norm = (e.index - 1) / (std::pow(e.gamma_min, 1 - e.index) - std::pow(e.gamma_max, 1 - e.index)),
                 there = norm * std::pow(u, 1 - e.index);
    return {there, there * (e.index + 2)};
}

void add(ElectronIntegrals& sum, const Number& n, double u, double s, const Kernels& k) {
    sum.emitted += n.there * k[kI], sum.emitted_q += n.there * k[kQ], sum.emitted_v += n.there * k[kV] / u;
    sum.absorbed += n.falls / u * k[kI], sum.absorbed_q += n.falls / u * k[kQ],
        sum.absorbed_v += n.falls / (u * u) * k[kV];
    sum.conversion += n.falls / u * 0.75 * s * k[kConvert];
    sum.rotation += n.falls / (u * u) * k[kTurn];
}

}  // namespace

ElectronIntegrals electron_integrals(const ElectronSpec& e, bool isotropic, double s) {
    const bool kappa = e.kind == ElectronKind::kKappa;
    constexpr double kPanelWidth = 0.4, kNothing = 1e-11;
    const double low = std::log(kappa ? 1e-4 / e.kappa : e.gamma_min),
                 high = kappa ? std::log(std::max({1.0, std::sqrt(s)})) - std::log(kNothing) / (e.kappa - 2 + 2.0 / 3)
                              : std::log(e.gamma_max);
    const int panels = static_cast<int>(std::ceil((high - low) / kPanelWidth));
    using Rule = boost::math::quadrature::gauss<double, 10>;
    ElectronIntegrals sum{};
    for (int p = 0; p < panels; ++p) {
        const double half = 0.5 * (high - low) / panels, middle = low + (2 * p + 1) * half;
        for (std::size_t i = 0; i < Rule::abscissa().size(); ++i)
            for (const double side : {-1.0, 1.0}) {
                const double u = std::exp(middle + side * half * Rule::abscissa()[i]),
                             weight = half * Rule::weights()[i];
                const Number n = number_at(e, u);
                add(sum, {weight * n.there, weight * n.falls}, u, s, kernels_or_mean(s / (u * u), isotropic));
            }
    }
    if (kappa) return sum;
    // The jumps of f: up at its first energy, down at its last.
    for (const auto& [gamma, side] : {std::pair{e.gamma_min, -1.0}, {e.gamma_max, 1.0}})
        add(sum, {0, side * number_at(e, gamma).there}, gamma, s, kernels_or_mean(s / (gamma * gamma), isotropic));
    return sum;
}

ElectronMeans electron_means(const ElectronSpec& e, double w) {
    static boost::math::quadrature::exp_sinh<double> rule;
    if (e.kind == ElectronKind::kKappa) {
        const auto integral = [&](const auto& f) {
            return rule.integrate(
                [&](double more) { return f(1 + more) * std::pow(1 + more / (e.kappa * w), -e.kappa - 1); }, 0.0,
                std::numeric_limits<double>::infinity(), 1e-9);
        };
        const double sum = integral([](double g) { return g * std::sqrt(g * g - 1); });
        return {integral([](double g) { return std::acosh(g); }) / sum,
                integral([](double g) { return std::sqrt(g * g - 1); }) / sum, sum};
    }
    ElectronMeans means{0, 0, 1};
    const double from = std::log(e.gamma_min), to = std::log(e.gamma_max);
    const int panels = static_cast<int>(std::ceil(4 * (to - from)));
    for (int p = 0; p < panels; ++p) {
        const double width = (to - from) / panels;
        const auto over = [&](const auto& f) {
            return boost::math::quadrature::gauss<double, 20>::integrate(
                [&](double log_gamma) {
                    const double gamma = std::exp(log_gamma);
                    return number_at(e, gamma).there * f(gamma);
                },
                from + p * width, from + (p + 1) * width);
        };
        means.rotation += over([](double g) { return std::acosh(g) / (g * std::sqrt(g * g - 1)); });
        means.inverse += over([](double g) { return 1 / g; });
    }
    return means;
}

}  // namespace nullscope::reference
