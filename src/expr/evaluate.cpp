#include <algorithm>
#include <cmath>
#include <cstdint>

#include "expr/formula.h"

namespace nullscope::expr {
namespace {

double bounded(double x) { return std::clamp(x, -kLargest, kLargest); }
double divide(double a, double b) {
    const double divisor = std::abs(b) < kSmallest ? (b < 0 ? -kSmallest : kSmallest) : b;
    return bounded(a / divisor);
}
double turn(double a) { return std::clamp(a, -kLargestAngle, kLargestAngle); }
double whole_power(double base, int n) {
    double result = 1;
    for (int i = 0; i < std::abs(n); ++i) result = bounded(result * base);
    return n < 0 ? divide(1, result) : result;
}
double smooth(double low, double high, double x) {
    const double t = std::clamp(divide(x - low, high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// A lattice point's number in [0, 1): three odd multipliers, then mixed by shifts.
double lattice(std::int32_t x, std::int32_t y, std::int32_t z) {
    std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9E3779B1u ^ static_cast<std::uint32_t>(y) * 0x85157AF5u ^
                      static_cast<std::uint32_t>(z) * 0xC3D2E1F1u;
    h ^= h >> 16;
    h *= 0x7FEB352Du;
    h ^= h >> 15;
    h *= 0x6C8E9CF5u;
    h ^= h >> 16;
    return (h >> 8) / 16777216.0;
}

}  // namespace

double noise(double x, double y, double z) {
    constexpr double kFar = 1e6;  // beyond it the pattern stands still
    const double cx = std::clamp(x, -kFar, kFar), cy = std::clamp(y, -kFar, kFar), cz = std::clamp(z, -kFar, kFar);
    const double fx = std::floor(cx), fy = std::floor(cy), fz = std::floor(cz);
    const auto ix = static_cast<std::int32_t>(fx), iy = static_cast<std::int32_t>(fy),
               iz = static_cast<std::int32_t>(fz);
    const auto ease = [](double t) { return t * t * (3 - 2 * t); };
    const double tx = ease(cx - fx), ty = ease(cy - fy), tz = ease(cz - fz);
    const auto mix = [](double a, double b, double t) { return a + (b - a) * t; };
    const auto row = [&](int j, int k) {
        return mix(lattice(ix, iy + j, iz + k), lattice(ix + 1, iy + j, iz + k), tx);
    };
    return mix(mix(row(0, 0), row(1, 0), ty), mix(row(0, 1), row(1, 1), ty), tz);
}

double Formula::value(std::span<const double> values) const {
    std::array<double, kMostNodes> at;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const Node& n = nodes_[i];
        const double a = at[static_cast<std::size_t>(n.arguments[0])], b = at[static_cast<std::size_t>(n.arguments[1])],
                     c = at[static_cast<std::size_t>(n.arguments[2])];
        switch (n.op) {
            case Op::kNumber: at[i] = n.number; break;
            case Op::kVariable: at[i] = values[n.variable]; break;
            case Op::kAdd: at[i] = bounded(a + b); break;
            case Op::kSubtract: at[i] = bounded(a - b); break;
            case Op::kMultiply: at[i] = bounded(a * b); break;
            case Op::kDivide: at[i] = divide(a, b); break;
            case Op::kPower: {
                const Node& exponent = nodes_[static_cast<std::size_t>(n.arguments[1])];
                const bool whole = exponent.op == Op::kNumber && is_whole(exponent.number);
                at[i] = whole ? whole_power(a, static_cast<int>(b))
                              : std::exp(std::clamp(b * std::log(std::max(a, kSmallest)), -69.0, 69.0));
                break;
            }
            case Op::kNegate: at[i] = -a; break;
            case Op::kSin: at[i] = std::sin(turn(a)); break;
            case Op::kCos: at[i] = std::cos(turn(a)); break;
            case Op::kTan: at[i] = divide(std::sin(turn(a)), std::cos(turn(a))); break;
            case Op::kAtan: at[i] = std::atan(a); break;
            case Op::kAtan2: at[i] = std::atan2(a, b); break;
            case Op::kSqrt: at[i] = std::sqrt(std::max(a, 0.0)); break;
            case Op::kAbs: at[i] = std::abs(a); break;
            case Op::kExp: at[i] = std::exp(std::clamp(a, -69.0, 69.0)); break;
            case Op::kLog: at[i] = std::log(std::max(a, kSmallest)); break;
            case Op::kMin: at[i] = std::min(a, b); break;
            case Op::kMax: at[i] = std::max(a, b); break;
            case Op::kClamp: at[i] = std::min(std::max(a, b), c); break;
            case Op::kMix: at[i] = bounded(a + bounded(bounded(b - a) * c)); break;
            case Op::kStep: at[i] = b < a ? 0 : 1; break;
            case Op::kSmoothstep: at[i] = smooth(a, b, c); break;
            case Op::kFloor: at[i] = std::floor(a); break;
            case Op::kMod: at[i] = bounded(a - bounded(b * std::floor(divide(a, b)))); break;
            case Op::kLength2: at[i] = bounded(std::hypot(a, b)); break;
            case Op::kLength3: at[i] = bounded(std::hypot(a, b, c)); break;
            case Op::kNoise1: at[i] = noise(a, 0, 0); break;
            case Op::kNoise2: at[i] = noise(a, b, 0); break;
            case Op::kNoise3: at[i] = noise(a, b, c); break;
        }
    }
    return at[nodes_.size() - 1];
}

bool Formula::uses(std::size_t variable) const {
    return std::any_of(nodes_.begin(), nodes_.end(),
                       [&](const Node& n) { return n.op == Op::kVariable && n.variable == variable; });
}

}  // namespace nullscope::expr
