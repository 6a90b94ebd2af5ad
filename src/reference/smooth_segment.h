// A monotone part of an orbit in a variable w in which d(phi)/dw is smooth: panels of Gauss nodes, and their inverse.
#pragma once
#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <cstddef>
#include <utility>
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

// Of the polynomial through values at the nodes of PanelGauss, in the order in which that asks for them: its sum of Chebyshev's.
inline constexpr std::size_t kPanelTerms = 20;
using PanelValues = std::array<double, kPanelTerms>;
inline PanelValues chebyshev_of_gauss(const PanelValues& values) {
    static const std::array<PanelValues, kPanelTerms> shares = [] {
        std::array<PanelValues, kPanelTerms> of_node{};
        PanelValues nodes{};
        std::size_t asked = 0;
        PanelGauss::integrate([&](double x) { return nodes[asked++] = x; }, -1.0, 1.0);
        // By Legendre's polynomials, which the rule holds apart: (n + 1) P_(n+1) = (2 n + 1) x P_n - n P_(n-1).
        for (std::size_t i = 0; i < kPanelTerms; ++i) {
            PanelValues there{};
            for (std::size_t k = 0; k < kPanelTerms; ++k) {
                const double x = nodes[i], y = chebyshev_places<kPanelTerms>()[k];
                double at_x = 1, before_x = 0, at_y = 1, before_y = 0;
                for (std::size_t n = 0; n < kPanelTerms; ++n) {
                    const double degree = static_cast<double>(n);
                    there[k] += (degree + 0.5) * PanelGauss::weights()[i / 2] * at_x * at_y;
                    before_x = std::exchange(at_x, ((2 * degree + 1) * x * at_x - degree * before_x) / (degree + 1));
                    before_y = std::exchange(at_y, ((2 * degree + 1) * y * at_y - degree * before_y) / (degree + 1));
                }
            }
            of_node[i] = chebyshev_terms(there);
        }
        return of_node;
    }();
    PanelValues terms{};
    for (std::size_t i = 0; i < kPanelTerms; ++i)
        for (std::size_t k = 0; k < kPanelTerms; ++k) terms[k] += values[i] * shares[i][k];
    return terms;
}

// The integral of a rate > 0 from `from` to `to`, as integrate_panels has it, and the inverse of that from `from` on, for any number of
// values. Panels are taken once, when they are first needed. Where a value is sought, its panel's rate is a sum of Chebyshev's polynomials
// through Gauss' nodes: half as many digits of it as of the rule's are 16: that is w to 1e-13, and one step of Newton's with Gauss' rule,
// which converges twice as fast, leaves its roundings. Without it the radii of crossings are off by 1.6 of the bound of tests/proof (a
// charged hole, NULLSCOPE_SEED=1).
class PanelInverse {
public:
    PanelInverse(double from, double to, double panel) { go_on(from, to, panel); }
    // rate, here and below: always the same.
    template <class Rate>
    double whole(const Rate& rate) {
        double sum = 0;
        for (Panel& panel : panels_) sum += panel.take(rate).whole;
        return sum;
    }
    // The same from the other end on.
    PanelInverse backward() const {
        PanelInverse other(*this);
        std::ranges::reverse(other.panels_);
        for (Panel& panel : other.panels_) panel.turn();
        return other;
    }
    // By more panels, `from` where the last one ends.
    void go_on(double from, double to, double panel) {
        const double count = std::max(1.0, std::ceil(std::abs(to - from) / panel)), step = (to - from) / count;
        for (double i = 0; i < count; ++i) panels_.push_back({from + step * i, from + step * (i + 1)});
    }
    // w with that integral equal to `value` (of the sign of the direction towards `to`).
    template <class Rate>
    double operator()(const Rate& rate, double value) {
        double left = value;
        std::size_t i = 0;
        for (; i + 1 < panels_.size() && std::abs(panels_[i].take(rate).whole) < std::abs(left); ++i)
            left -= panels_[i].whole;
        Panel& here = panels_[i].take(rate);
        here.make_sums();
        const double half = 0.5 * (here.to - here.from);
        double x = std::clamp(2 * left / here.whole - 1, -1.0, 1.0);
        for (int turn = 0; turn < kMostTurns; ++turn) {
            const double next = std::clamp(
                x - (half * chebyshev_sum(here.sum, x) - left) / (half * chebyshev_sum(here.rate, x)), -1.0, 1.0);
            const bool settled = std::abs(next - x) <= kSettled;
            x = next;
            if (settled) break;
        }
        double w = here.from + half * (x + 1);
        // Next to where the panel begins its sum has lost digits that the value has: once more.
        const int turns = std::abs(left) < kSmallPart * std::abs(here.whole) ? 2 : 1;
        for (int turn = 0; turn < turns; ++turn) w -= (PanelGauss::integrate(rate, here.from, w) - left) / rate(w);
        return std::clamp(w, std::min(here.from, here.to), std::max(here.from, here.to));
    }

private:
    static constexpr int kMostTurns = 12;
    static constexpr double kSettled = 2e-16, kSmallPart = 1e-3;
    struct Panel {
        double from, to;
        bool taken = false, summed = false;
        double whole = 0;
        PanelValues values{};  // of the rate, at Gauss' nodes
        PanelValues rate{};
        std::array<double, kPanelTerms + 1> sum{};
        template <class Rate>
        Panel& take(const Rate& of) {
            if (taken) return *this;
            std::size_t asked = 0;
            whole = PanelGauss::integrate([&](double w) { return values[asked++] = of(w); }, from, to);
            if (to < from) mirror();  // the rule goes upward
            taken = true;
            return *this;
        }
        void mirror() {
            for (std::size_t i = 0; i + 1 < kPanelTerms; i += 2) std::swap(values[i], values[i + 1]);
        }
        void make_sums() {
            if (summed) return;
            rate = chebyshev_of_gauss(values), sum = chebyshev_integral(rate), summed = true;
        }
        void turn() {
            std::swap(from, to);
            whole *= -1, summed = false;
            mirror();
        }
    };
    std::vector<Panel> panels_;
};

}  // namespace nullscope::reference
