// A monotone part of an orbit in a variable w in which d(phi)/dw is smooth: panels of Gauss nodes, and their inverse.
#pragma once
#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <cstddef>
#include <vector>

#include "reference/chebyshev.h"

namespace nullscope::reference {

// Integrands here have their singularities at |Im w| = pi/2 or beyond: 20 nodes on 1/2 converge as (6.4)^-40 there.
inline constexpr double kPanel = 0.5;
using PanelGauss = boost::math::quadrature::gauss<double, 20>;

template <class Rate>
double integrate_panels(const Rate& rate, double from, double to, double panel = kPanel) {
    const int count = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / panel)));
    double sum = 0;
    for (int i = 0; i < count; ++i)
        sum += PanelGauss::integrate(rate, from + (to - from) * i / count, from + (to - from) * (i + 1) / count);
    return sum;
}

// The inverse of the integral of a rate > 0 from `from` on, towards `to`, for any number of values: each panel's rate is a sum of
// Chebyshev's polynomials at as many places as Gauss' rule has, taken once, when a value is first sought so far. Half as many digits of
// theirs as of the rule's are 16: that is w to 1e-13, and one step of Newton's with Gauss' rule, which converges twice as fast, leaves its
// roundings. Without it the radii of crossings are off by 1.6 of the bound of tests/proof (a charged hole, NULLSCOPE_SEED=1).
class PanelInverse {
public:
    PanelInverse(double from, double to, double panel)
        : from_(from),
          count_(static_cast<std::size_t>(std::max(1.0, std::ceil(std::abs(to - from) / panel)))),
          step_((to - from) / static_cast<double>(count_)) {}
    // w with that integral equal to `value` (of the sign of the direction towards `to`). rate: always the same.
    template <class Rate>
    double operator()(const Rate& rate, double value) {
        double left = value;
        std::size_t i = 0;
        for (; i < count_; ++i) {
            if (i == panels_.size()) panels_.push_back(panel(rate, start(i)));
            if (i + 1 == count_ || std::abs(panels_[i].whole) >= std::abs(left)) break;
            left -= panels_[i].whole;
        }
        const Panel& here = panels_[i];
        const double half = 0.5 * step_;
        double x = std::clamp(2 * left / here.whole - 1, -1.0, 1.0);
        for (int turn = 0; turn < kMostTurns; ++turn) {
            const double next = std::clamp(
                x - (half * chebyshev_sum(here.sum, x) - left) / (half * chebyshev_sum(here.rate, x)), -1.0, 1.0);
            const bool settled = std::abs(next - x) <= kSettled;
            x = next;
            if (settled) break;
        }
        double w = start(i) + half * (x + 1);
        // Next to where the panel begins its sum has lost digits that the value has: once more.
        const int turns = std::abs(left) < kSmallPart * std::abs(here.whole) ? 2 : 1;
        for (int turn = 0; turn < turns; ++turn) w -= (PanelGauss::integrate(rate, start(i), w) - left) / rate(w);
        const double begin = start(i), end = begin + step_;
        return std::clamp(w, std::min(begin, end), std::max(begin, end));
    }

private:
    static constexpr std::size_t kTerms = 20;
    static constexpr int kMostTurns = 12;
    static constexpr double kSettled = 2e-16, kSmallPart = 1e-3;
    struct Panel {
        std::array<double, kTerms> rate;
        std::array<double, kTerms + 1> sum;
        double whole;
    };
    double start(std::size_t i) const { return from_ + step_ * static_cast<double>(i); }
    template <class Rate>
    Panel panel(const Rate& rate, double begin) const {
        std::array<double, kTerms> values{};
        for (std::size_t k = 0; k < kTerms; ++k)
            values[k] = rate(begin + 0.5 * step_ * (1 + chebyshev_places<kTerms>()[k]));
        Panel made{chebyshev_terms(values), {}, 0};
        made.sum = chebyshev_integral(made.rate);
        made.whole = PanelGauss::integrate(rate, begin, begin + step_);
        return made;
    }
    double from_;
    std::size_t count_;
    double step_;
    std::vector<Panel> panels_;
};

}  // namespace nullscope::reference
