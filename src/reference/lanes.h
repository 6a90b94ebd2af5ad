// Several numbers side by side that one instruction works on: rays that are integrated together. Sums, products,
// quotients and square roots are rounded to nearest whatever the width, and nothing else is done to lanes: what comes
// out are the same bits as of one number at a time.
#pragma once
#include <cmath>
#include <cstddef>

namespace nullscope::reference {

template <std::size_t Width>
struct LaneVector;
template <>
struct LaneVector<2> {
    typedef double Type __attribute__((vector_size(16)));  // NOLINT: a compiler's vector, of no other name
};
template <>
struct LaneVector<4> {
    typedef double Type __attribute__((vector_size(32)));  // NOLINT
};
template <>
struct LaneVector<8> {
    typedef double Type __attribute__((vector_size(64)));  // NOLINT
};

template <std::size_t Width>
struct Lanes {
    using Vector = typename LaneVector<Width>::Type;
    Vector v;

    Lanes() = default;
    Lanes(double x) : v(Vector{} + x) {}  // NOLINT: a number is all lanes
    explicit Lanes(const Vector& x) : v(x) {}
    friend Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(a.v + b.v); }
    friend Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(a.v - b.v); }
    friend Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(a.v * b.v); }
    friend Lanes operator/(const Lanes& a, const Lanes& b) { return Lanes(a.v / b.v); }
    friend Lanes sqrt(const Lanes& a) {
        Lanes root;
        for (std::size_t i = 0; i < Width; ++i) root.v[i] = std::sqrt(a.v[i]);
        return root;
    }
    // Lane by lane: `a` where `sign` > 0, else `b`.
    friend Lanes where_positive(const Lanes& sign, const Lanes& a, const Lanes& b) {
        return Lanes(sign.v > 0 ? a.v : b.v);
    }
};

inline double where_positive(double sign, double a, double b) { return sign > 0 ? a : b; }

}  // namespace nullscope::reference
