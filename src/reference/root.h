// Roots of a function between two places where it has opposite signs.
#pragma once
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace nullscope::reference {

// By TOMS 748, to `bits` of the place. at_low, at_high: the function's values there.
template <class Real, class F>
Real root_of(const F& f, Real low, Real high, Real at_low, Real at_high, int bits) {
    std::uintmax_t steps = 200;
    const auto [a, b] = boost::math::tools::toms748_solve(f, low, high, at_low, at_high,
                                                          boost::math::tools::eps_tolerance<Real>(bits), steps);
    return (a + b) / 2;
}
template <class Real, class F>
Real root_of(const F& f, Real low, Real high, int bits) {
    return root_of(f, low, high, f(low), f(high), bits);
}

// By halves, to the last digit of a long double; positive at low, not at high.
template <class F>
long double root_between(const F& f, long double low, long double high) {
    for (int i = 0; i < 200 && std::abs(high - low) > 1e-19L * std::abs(high); ++i) {
        const long double middle = (low + high) / 2;
        (f(middle) > 0 ? low : high) = middle;
    }
    return (low + high) / 2;
}

}  // namespace nullscope::reference
