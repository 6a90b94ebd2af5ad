// Truncated power series in one small variable t, and what formulas do with them: the value of a formula at a place and all of its
// derivatives there, or its expansion about infinity, where the first power is below 0. No differences are taken.
//
// f = t^power (c[0] + c[1] t + ... + c[terms - 1] t^(terms - 1)); the terms from there on are not known. A function that has no such
// expansion at that place (log of 1/t, a root with a branch point) gives coefficients that are not finite, as does a division by 0.
// The recurrences are those of automatic differentiation (Griewank and Walther, Evaluating Derivatives, chapter 13).
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace nullscope::expr {

template <class Real, int kTerms>
struct Series {
    static_assert(kTerms >= 2);
    int power = 0, terms = kTerms;
    std::array<Real, kTerms> c{};

    Series() = default;
    explicit Series(Real constant) { c[0] = constant; }
    // centre + t
    static Series variable(Real centre) {
        Series s(centre);
        s.c[1] = 1;
        return s;
    }
    static Series unknown() { return Series(std::numeric_limits<Real>::quiet_NaN()); }
    // Of t^k; not a number where it is not known.
    Real of_power(int k) const {
        if (k < power) return 0;
        return k - power < terms ? c[static_cast<std::size_t>(k - power)] : std::numeric_limits<Real>::quiet_NaN();
    }
    Real& operator[](int i) { return c[static_cast<std::size_t>(i)]; }
    Real operator[](int i) const { return c[static_cast<std::size_t>(i)]; }
    // c[0] is not 0, unless all are.
    Series led() const {
        int zeros = 0;
        while (zeros < terms && (*this)[zeros] == 0) ++zeros;
        if (zeros == 0 || zeros == terms) return *this;
        Series s;
        s.power = power + zeros, s.terms = terms - zeros;
        std::copy(c.begin() + zeros, c.begin() + terms, s.c.begin());
        return s;
    }
};

template <class Real, int n>
Series<Real, n> operator-(Series<Real, n> a) {
    for (Real& c : a.c) c = -c;
    return a;
}

template <class Real, int n>
Series<Real, n> operator+(const Series<Real, n>& a, const Series<Real, n>& b) {
    if (a.power > b.power) return b + a;
    const int shift = b.power - a.power;
    Series<Real, n> s = a;
    s.terms = std::min(a.terms, shift + b.terms);
    for (int i = shift; i < s.terms; ++i) s[i] += b[i - shift];
    return s;
}

template <class Real, int n>
Series<Real, n> operator-(const Series<Real, n>& a, const Series<Real, n>& b) {
    return a + -b;
}

template <class Real, int n>
Series<Real, n> operator*(const Series<Real, n>& a, const Series<Real, n>& b) {
    Series<Real, n> s;
    s.power = a.power + b.power, s.terms = std::min(a.terms, b.terms);
    for (int i = 0; i < s.terms; ++i)
        for (int j = 0; j <= i; ++j) s[i] += a[j] * b[i - j];
    return s;
}

template <class Real, int n>
Series<Real, n> operator/(const Series<Real, n>& a, const Series<Real, n>& divisor) {
    const Series<Real, n> b = divisor.led();
    Series<Real, n> s;
    s.power = a.power - b.power, s.terms = std::min(a.terms, b.terms);
    for (int i = 0; i < s.terms; ++i) {
        Real rest = a[i];
        for (int j = 0; j < i; ++j) rest -= s[j] * b[i - j];
        s[i] = rest / b[0];
    }
    return s;
}

// The same with power 0, for functions that have no other expansion.
template <class Real, int n>
Series<Real, n> regular(const Series<Real, n>& a) {
    if (a.power == 0) return a;
    if (a.power < 0 &&
        std::any_of(a.c.begin(), a.c.begin() + std::min(-a.power, a.terms), [](Real c) { return c != 0; }))
        return Series<Real, n>::unknown();
    Series<Real, n> s;
    s.terms = std::clamp(a.terms + a.power, 1, n);
    for (int i = 0; i < s.terms; ++i) s[i] = a.of_power(i);
    return s;
}

// a^exponent by f' a = exponent f a'.
template <class Real, int n>
Series<Real, n> power_of(const Series<Real, n>& base, Real exponent) {
    const Series<Real, n> a = base.led();
    const Real first = exponent * a.power;
    Series<Real, n> s;
    s.terms = a.terms;
    s.power = static_cast<int>(std::fmax(std::fmin(first, Real(1000)), Real(-1000)));
    s[0] = first == Real(s.power) ? std::pow(a[0], exponent) : std::numeric_limits<Real>::quiet_NaN();
    for (int i = 1; i < s.terms; ++i) {
        Real sum = 0;
        for (int j = 1; j <= i; ++j) sum += (exponent * Real(j) - Real(i - j)) * a[j] * s[i - j];
        s[i] = sum / (Real(i) * a[0]);
    }
    return s;
}
template <class Real, int n>
Series<Real, n> sqrt(const Series<Real, n>& a) {
    return power_of(a, Real(0.5));
}

// f' = a' f
template <class Real, int n>
Series<Real, n> exp(const Series<Real, n>& exponent) {
    const Series<Real, n> a = regular(exponent);
    Series<Real, n> s;
    s.terms = a.terms;
    s[0] = std::exp(a[0]);
    for (int i = 1; i < s.terms; ++i) {
        Real sum = 0;
        for (int j = 1; j <= i; ++j) sum += Real(j) * a[j] * s[i - j];
        s[i] = sum / Real(i);
    }
    return s;
}

// The integral of a'/divisor, and first: the value.
template <class Real, int n>
Series<Real, n> integrated(Real first, const Series<Real, n>& a, const Series<Real, n>& divisor) {
    Series<Real, n> s;
    s.terms = std::min(a.terms, divisor.terms);
    s[0] = first;
    for (int i = 1; i < s.terms; ++i) {  // divisor s' = a'
        Real rest = Real(i) * a[i];
        for (int j = 1; j < i; ++j) rest -= Real(j) * s[j] * divisor[i - j];
        s[i] = rest / (Real(i) * divisor[0]);
    }
    return s;
}
template <class Real, int n>
Series<Real, n> log(const Series<Real, n>& argument) {
    const Series<Real, n> a = argument.led();
    if (a.power != 0) return Series<Real, n>::unknown();
    return integrated(std::log(a[0]), a, a);
}
template <class Real, int n>
Series<Real, n> atan(const Series<Real, n>& argument) {
    const Series<Real, n> a = regular(argument);
    return integrated(std::atan(a[0]), a, Series<Real, n>(Real(1)) + a * a);
}

template <class Real, int n>
struct SineAndCosine {
    Series<Real, n> sine, cosine;
};
template <class Real, int n>
SineAndCosine<Real, n> sine_and_cosine(const Series<Real, n>& angle) {
    const Series<Real, n> a = regular(angle);
    Series<Real, n> s, c;
    s.terms = c.terms = a.terms;
    s[0] = std::sin(a[0]), c[0] = std::cos(a[0]);
    for (int i = 1; i < a.terms; ++i) {
        for (int j = 1; j <= i; ++j) {
            s[i] += Real(j) * a[j] * c[i - j] / Real(i);
            c[i] -= Real(j) * a[j] * s[i - j] / Real(i);
        }
    }
    return {s, c};
}
template <class Real, int n>
Series<Real, n> sin(const Series<Real, n>& a) {
    return sine_and_cosine(a).sine;
}
template <class Real, int n>
Series<Real, n> cos(const Series<Real, n>& a) {
    return sine_and_cosine(a).cosine;
}

}  // namespace nullscope::expr
