// A monotone part of an orbit in a variable w in which d(phi)/dw is smooth: panels of Gauss nodes, and their inverse.
#pragma once
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

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

// w with integral of rate from `from` to w equal to `value` (of the sign of the direction towards `to`); rate > 0.
template <class Rate>
double invert_panels(const Rate& rate, double from, double to, double value, double panel = kPanel) {
    const int count = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / panel)));
    const double step = (to - from) / count;
    double left = value, start = from;
    for (int i = 0; i + 1 < count; ++i) {
        const double part = PanelGauss::integrate(rate, start, start + step);
        if (std::abs(part) >= std::abs(left)) break;
        left -= part;
        start = from + (i + 1) * step;
    }
    double w = start + left / rate(start);
    const double low = std::min(start, start + step), high = std::max(start, start + step);
    for (int i = 0; i < 12; ++i) {
        w = std::clamp(w, low, high);
        const double off = PanelGauss::integrate(rate, start, w) - left;
        const double next = w - off / rate(w);
        if (std::abs(next - w) <= 1e-15 * (1 + std::abs(w))) return std::clamp(next, low, high);
        w = next;
    }
    return w;
}

}  // namespace nullscope::reference
