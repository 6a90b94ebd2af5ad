// Dual numbers: a value and its derivatives by N things, which arithmetic carries along by the chain rule (R. E. Wengert, Comm. ACM 7, 463
// (1964)). Exact but for rounding. Real may be a Dual itself: derivatives of derivatives.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

namespace nullscope {

template <class Real, std::size_t N>
struct Dual {
    Real value{};
    std::array<Real, N> d{};

    Dual() = default;
    Dual(double constant)
        : value(constant) {}  // NOLINT(google-explicit-constructor): a number is one of no derivatives
    static Dual variable(const Real& value, std::size_t i) {
        Dual x;
        x.value = value, x.d[i] = Real(1.0);
        return x;
    }

    friend Dual operator-(const Dual& a) { return scaled(a, Real(-1.0)); }
    friend Dual operator+(Dual a, const Dual& b) {
        a.value = a.value + b.value;
        for (std::size_t i = 0; i < N; ++i) a.d[i] = a.d[i] + b.d[i];
        return a;
    }
    friend Dual operator-(Dual a, const Dual& b) {
        a.value = a.value - b.value;
        for (std::size_t i = 0; i < N; ++i) a.d[i] = a.d[i] - b.d[i];
        return a;
    }
    friend Dual operator*(const Dual& a, const Dual& b) {
        Dual x;
        x.value = a.value * b.value;
        for (std::size_t i = 0; i < N; ++i) x.d[i] = a.d[i] * b.value + a.value * b.d[i];
        return x;
    }
    friend Dual operator*(double s, const Dual& a) { return scaled(a, Real(s)); }
    friend Dual operator/(const Dual& a, const Dual& b) {
        Dual x;
        const Real inverse = Real(1.0) / b.value;
        x.value = a.value / b.value;
        for (std::size_t i = 0; i < N; ++i) x.d[i] = (a.d[i] - x.value * b.d[i]) * inverse;
        return x;
    }
    friend Dual scaled(Dual a, const Real& s) {
        a.value = a.value * s;
        for (Real& part : a.d) part = part * s;
        return a;
    }
    // f(a), where f's derivative is `slope`.
    friend Dual chained(Dual a, const Real& f, const Real& slope) {
        a.value = f;
        for (Real& part : a.d) part = part * slope;
        return a;
    }
};

template <class Real, std::size_t N>
Dual<Real, N> sqrt(const Dual<Real, N>& a) {
    using std::sqrt;
    const Real root = sqrt(a.value);
    return chained(a, root, Real(0.5) / root);
}
template <class Real, std::size_t N>
Dual<Real, N> exp(const Dual<Real, N>& a) {
    using std::exp;
    const Real power = exp(a.value);
    return chained(a, power, power);
}
template <class Real, std::size_t N>
Dual<Real, N> log(const Dual<Real, N>& a) {
    using std::log;
    return chained(a, Real(log(a.value)), Real(1.0) / a.value);
}
template <class Real, std::size_t N>
Dual<Real, N> sin(const Dual<Real, N>& a) {
    using std::cos;
    using std::sin;
    return chained(a, Real(sin(a.value)), Real(cos(a.value)));
}
template <class Real, std::size_t N>
Dual<Real, N> cos(const Dual<Real, N>& a) {
    using std::cos;
    using std::sin;
    return chained(a, Real(cos(a.value)), -Real(sin(a.value)));
}
template <class Real, std::size_t N>
Dual<Real, N> atan(const Dual<Real, N>& a) {
    using std::atan;
    return chained(a, Real(atan(a.value)), Real(1.0) / (Real(1.0) + a.value * a.value));
}
// As formulas call it (expr/smooth.h); base > 0.
template <class Real, std::size_t N>
Dual<Real, N> power_of(const Dual<Real, N>& base, double exponent) {
    return exp(exponent * log(base));
}

}  // namespace nullscope
