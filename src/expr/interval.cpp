#include "expr/interval.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>

namespace nullscope::expr {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kRounding = 1e-12;  // of a bound, relative: what an operation and its functions may round
constexpr Interval kAll{-kLargest, kLargest};

Interval clamped(Interval a, double low, double high) {
    return {std::clamp(a.low, low, high), std::clamp(a.high, low, high)};
}
Interval bounded(Interval a) {
    return clamped({a.low - kRounding * std::fabs(a.low), a.high + kRounding * std::fabs(a.high)}, -kLargest, kLargest);
}
Interval hull(std::initializer_list<double> of) {
    const auto [low, high] = std::minmax(of);
    return bounded({low, high});
}
bool contains(Interval a, double x) { return a.low <= x && x <= a.high; }

Interval add(Interval a, Interval b) { return bounded({a.low + b.low, a.high + b.high}); }
Interval negated(Interval a) { return {-a.high, -a.low}; }
Interval times(Interval a, Interval b) {
    return hull({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
}
Interval divide(Interval a, Interval b) {
    if (b.low < kSmallest && b.high > -kSmallest) return kAll;
    return hull({a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high});
}

template <class F>
Interval rising(const F& f, Interval a) {  // f: monotonic
    return hull({f(a.low), f(a.high)});
}

Interval absolute(Interval a) {
    const double low = std::fabs(a.low), high = std::fabs(a.high);
    return {contains(a, 0) ? 0 : std::min(low, high), std::max(low, high)};
}

Interval whole_power(Interval base, int n) {
    const int times_multiplied = std::abs(n);
    const Interval from = times_multiplied % 2 == 0 ? absolute(base) : base;
    const Interval result =
        rising([&](double x) { return std::clamp(std::pow(x, times_multiplied), -kLargest, kLargest); }, from);
    return n < 0 ? divide({1, 1}, result) : result;
}

Interval exponential(Interval a) {
    return rising([](double x) { return std::exp(x); }, clamped(a, -69.0, 69.0));
}
Interval logarithm(Interval a) {
    return rising([](double x) { return std::log(std::max(x, kSmallest)); }, a);
}

// The cosine of angles less `behind`: its extremes lie at whole half turns.
Interval cosine(Interval a, double behind) {
    const Interval angle = clamped(a, -kLargestAngle, kLargestAngle);
    const double low = angle.low - behind, high = angle.high - behind;
    const auto passes = [&](double phase) {  // one of phase + 2 pi n lies between, or next to it
        return std::floor((high - phase) / kTurn + 1e-9) >= std::ceil((low - phase) / kTurn - 1e-9);
    };
    const Interval ends = hull({std::cos(low), std::cos(high)});
    return {passes(std::numbers::pi) ? -1 : ends.low, passes(0) ? 1 : ends.high};
}
Interval sine(Interval a) { return cosine(a, 0.5 * std::numbers::pi); }

Interval arc_tangent(Interval y, Interval x) {
    const bool cut = !(x.low > 0 || y.low > 0 || y.high < 0);  // the negative x axis, or the origin
    if (cut) return bounded({-std::numbers::pi, std::numbers::pi});
    return hull(
        {std::atan2(y.low, x.low), std::atan2(y.low, x.high), std::atan2(y.high, x.low), std::atan2(y.high, x.high)});
}

Interval smooth(Interval low, Interval high, Interval x) {
    const Interval t = clamped(divide(add(x, negated(low)), add(high, negated(low))), 0, 1);
    return rising([](double s) { return s * s * (3 - 2 * s); }, t);
}

Interval floor_of(Interval a) { return {std::floor(a.low), std::floor(a.high)}; }

Interval remainder(Interval a, Interval b) {
    const Interval whole = floor_of(divide(a, b));
    const double most = std::max(std::fabs(b.low), std::fabs(b.high)), slack = kRounding * most;
    const Interval exact = add(a, negated(times(b, whole)));
    if (contains(b, 0)) return exact;
    const Interval within = b.low > 0 ? Interval{-slack, most + slack} : Interval{-most - slack, slack};
    return {std::max(exact.low, within.low), std::min(exact.high, within.high)};
}

Interval length(std::initializer_list<Interval> parts) {
    double low = 0, high = 0;
    for (const Interval part : parts) {
        const Interval size = absolute(part);
        low = std::hypot(low, size.low), high = std::hypot(high, size.high);
    }
    return bounded({low, high});
}

}  // namespace

Interval range(const Formula& formula, std::span<const Interval> values) {
    const std::vector<Formula::Node>& nodes = formula.nodes();
    std::array<Interval, kMostNodes> at;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Formula::Node& n = nodes[i];
        const Interval a = at[static_cast<std::size_t>(n.arguments[0])],
                       b = at[static_cast<std::size_t>(n.arguments[1])],
                       c = at[static_cast<std::size_t>(n.arguments[2])];
        switch (n.op) {
            case Op::kNumber: at[i] = {n.number, n.number}; break;
            case Op::kVariable: at[i] = values[n.variable]; break;
            case Op::kAdd: at[i] = add(a, b); break;
            case Op::kSubtract: at[i] = add(a, negated(b)); break;
            case Op::kMultiply: at[i] = times(a, b); break;
            case Op::kDivide: at[i] = divide(a, b); break;
            case Op::kPower: {
                const Formula::Node& exponent = nodes[static_cast<std::size_t>(n.arguments[1])];
                const bool whole = exponent.op == Op::kNumber && is_whole(exponent.number);
                at[i] = whole ? whole_power(a, static_cast<int>(exponent.number)) : exponential(times(b, logarithm(a)));
                break;
            }
            case Op::kNegate: at[i] = negated(a); break;
            case Op::kSin: at[i] = sine(a); break;
            case Op::kCos: at[i] = cosine(a, 0); break;
            case Op::kTan: at[i] = divide(sine(a), cosine(a, 0)); break;
            case Op::kAtan: at[i] = rising([](double x) { return std::atan(x); }, a); break;
            case Op::kAtan2: at[i] = arc_tangent(a, b); break;
            case Op::kSqrt: at[i] = rising([](double x) { return std::sqrt(std::max(x, 0.0)); }, a); break;
            case Op::kAbs: at[i] = absolute(a); break;
            case Op::kExp: at[i] = exponential(a); break;
            case Op::kLog: at[i] = logarithm(a); break;
            case Op::kMin: at[i] = {std::min(a.low, b.low), std::min(a.high, b.high)}; break;
            case Op::kMax: at[i] = {std::max(a.low, b.low), std::max(a.high, b.high)}; break;
            case Op::kClamp:
                at[i] = {std::min(std::max(a.low, b.low), c.low), std::min(std::max(a.high, b.high), c.high)};
                break;
            case Op::kMix: at[i] = add(a, times(add(b, negated(a)), c)); break;
            case Op::kStep: at[i] = {b.low < a.high ? 0.0 : 1.0, b.high < a.low ? 0.0 : 1.0}; break;
            case Op::kSmoothstep: at[i] = smooth(a, b, c); break;
            case Op::kFloor: at[i] = floor_of(a); break;
            case Op::kMod: at[i] = remainder(a, b); break;
            case Op::kLength2: at[i] = length({a, b}); break;
            case Op::kLength3: at[i] = length({a, b, c}); break;
            case Op::kNoise1:
            case Op::kNoise2:
            case Op::kNoise3: at[i] = {0, 1}; break;
        }
    }
    return at[nodes.size() - 1];
}

}  // namespace nullscope::expr
