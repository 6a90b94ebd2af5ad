// Sums of Chebyshev's polynomials on [-1, 1]: from values at the polynomials' zeros, their value and their integral. Of a function that is
// regular within an ellipse about [-1, 1] whose half axes add up to rho, n terms leave rho^-n of it.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace nullscope::reference {

// The n places in [-1, 1], in falling order, at which chebyshev_terms wants the function.
template <std::size_t n, class Real = double>
const std::array<Real, n>& chebyshev_places() {
    static const std::array<Real, n> places = [] {
        std::array<Real, n> x{};
        for (std::size_t i = 0; i < n; ++i)
            x[i] = std::cos(std::numbers::pi_v<Real> * (static_cast<Real>(i) + Real(0.5)) / n);
        return x;
    }();
    return places;
}

template <class Real, std::size_t n>
std::array<Real, n> chebyshev_terms(const std::array<Real, n>& values) {
    static const std::array<std::array<Real, n>, n> shares = [] {
        std::array<std::array<Real, n>, n> s{};
        for (std::size_t k = 0; k < n; ++k)
            for (std::size_t i = 0; i < n; ++i)
                s[k][i] = Real(k == 0 ? 1 : 2) / n *
                          std::cos(std::numbers::pi_v<Real> * static_cast<Real>(k * (2 * i + 1)) / (2 * Real(n)));
        return s;
    }();
    std::array<Real, n> terms{};
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t i = 0; i < n; ++i) terms[k] += shares[k][i] * values[i];
    return terms;
}

// Clenshaw's sum; x in [-1, 1].
template <std::size_t n>
double chebyshev_sum(const std::array<double, n>& terms, double x) {
    double next = 0, after = 0;
    for (std::size_t k = n - 1; k > 0; --k) {
        const double here = terms[k] + 2 * x * next - after;
        after = next, next = here;
    }
    return terms[0] + x * next - after;
}

// Of the integral from -1 on.
template <std::size_t n>
std::array<double, n + 1> chebyshev_integral(const std::array<double, n>& terms) {
    std::array<double, n + 1> sum{};
    const auto term = [&](std::size_t k) { return k < n ? terms[k] : 0.0; };
    sum[1] = term(0) - 0.5 * term(2);
    for (std::size_t k = 2; k <= n; ++k) sum[k] = (term(k - 1) - term(k + 1)) / (2.0 * static_cast<double>(k));
    for (std::size_t k = 1; k <= n; ++k) sum[0] += k % 2 == 1 ? sum[k] : -sum[k];
    return sum;
}

// Of the derivative.
template <std::size_t n>
std::array<double, n> chebyshev_slope(const std::array<double, n>& terms) {
    std::array<double, n> slope{};
    for (std::size_t k = n - 1; k > 0; --k)
        slope[k - 1] = (k + 1 < n ? slope[k + 1] : 0.0) + 2.0 * static_cast<double>(k) * terms[k];
    slope[0] *= 0.5;
    return slope;
}

// Functions on [low, high] as sums on equal pieces.
template <std::size_t kFunctions, std::size_t n>
class ChebyshevPieces {
public:
    // f(x): an array of the functions' values.
    template <class F>
    ChebyshevPieces(const F& f, double low, double high, std::size_t pieces)
        : low_(low), width_((high - low) / static_cast<double>(pieces)), pieces_(pieces) {
        for (std::size_t p = 0; p < pieces; ++p) {
            std::array<std::array<double, n>, kFunctions> values{};
            for (std::size_t i = 0; i < n; ++i) {
                const auto at = f(low_ + width_ * (static_cast<double>(p) + 0.5 + 0.5 * chebyshev_places<n>()[i]));
                for (std::size_t k = 0; k < kFunctions; ++k) values[k][i] = at[k];
            }
            for (std::size_t k = 0; k < kFunctions; ++k) pieces_[p][k] = chebyshev_terms(values[k]);
        }
    }
    bool holds(double x) const { return x >= low_ && x < low_ + width_ * static_cast<double>(pieces_.size()); }
    std::array<double, kFunctions> operator()(double x) const {  // where holds(x)
        const double place = (x - low_) / width_;
        const std::size_t p = std::min(static_cast<std::size_t>(place), pieces_.size() - 1);
        std::array<double, kFunctions> values{};
        for (std::size_t k = 0; k < kFunctions; ++k)
            values[k] = chebyshev_sum(pieces_[p][k], 2 * (place - static_cast<double>(p)) - 1);
        return values;
    }

private:
    double low_, width_;
    std::vector<std::array<std::array<double, n>, kFunctions>> pieces_;
};

}  // namespace nullscope::reference
