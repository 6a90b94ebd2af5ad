// A polynomial through Chebyshev's nodes.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

namespace nullscope {

// Coefficients of 1, t, t^2, ... of the polynomial that is f at the n nodes in [-1, 1].
template <std::size_t n, class F>
std::array<double, n> powers_through_chebyshev(const F& f) {
    std::array<double, n> chebyshev{}, power{};
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = M_PI * (static_cast<double>(i) + 0.5) / n, value = f(std::cos(angle));
        for (std::size_t j = 0; j < n; ++j)
            chebyshev[j] += (j == 0 ? 1.0 : 2.0) / n * value * std::cos(static_cast<double>(j) * angle);
    }
    std::array<double, n + 1> previous{1.0}, current{0.0, 1.0};  // power coefficients of T_0, T_1
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t p = 0; p < n; ++p) power[p] += chebyshev[j] * previous[p];
        std::array<double, n + 1> next{};
        for (std::size_t p = 0; p < n; ++p) next[p + 1] = 2.0 * current[p];
        for (std::size_t p = 0; p <= n; ++p) next[p] -= previous[p];
        previous = current;
        current = next;
    }
    return power;
}

}  // namespace nullscope
