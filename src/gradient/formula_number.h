// Formulas of scene files in dual numbers (expr/formula.h has their meaning and their bounds): where a function has a kink the derivative is that of one of
// its sides, of step and floor 0.
#pragma once
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "expr/formula.h"
#include "expr/smooth.h"
#include "gradient/dual.h"

namespace nullscope {

// noise() has no derivatives here.
inline bool has_number(const expr::Formula& formula) {
    return std::ranges::none_of(formula.nodes(), [](const expr::Formula::Node& node) {
        return node.op == expr::Op::kNoise1 || node.op == expr::Op::kNoise2 || node.op == expr::Op::kNoise3;
    });
}

namespace formula_number {

template <class Value>
Value bounded(const Value& x) {
    if (x.value > expr::kLargest) return Value(expr::kLargest);
    if (x.value < -expr::kLargest) return Value(-expr::kLargest);
    return x;
}
template <class Value>
Value quotient(const Value& a, const Value& b) {
    if (std::fabs(b.value) < expr::kSmallest)
        return bounded(a / Value(b.value < 0 ? -expr::kSmallest : expr::kSmallest));
    return bounded(a / b);
}
template <class Value>
Value clamped(const Value& x, const Value& low, const Value& high) {
    const Value& above = x.value < low.value ? low : x;
    return above.value > high.value ? high : above;
}
template <class Value>
Value power(const Value& base, const expr::Formula::Node& exponent_node, const Value& exponent) {
    if (exponent_node.op == expr::Op::kNumber && expr::is_whole(exponent_node.number)) {
        const int n = static_cast<int>(exponent_node.number);
        const Value whole = expr::whole_power(base, std::abs(n), Value(1.0));
        return n < 0 ? quotient(Value(1.0), whole) : bounded(whole);
    }
    const Value least = base.value < expr::kSmallest ? Value(expr::kSmallest) : base;
    return exp(clamped(exponent * log(least), Value(-69.0), Value(69.0)));
}
template <class Value>
Value smooth_step(const Value& low, const Value& high, const Value& x) {
    const Value t = clamped(quotient(x - low, high - low), Value(0.0), Value(1.0));
    return t * t * (3.0 - 2.0 * t);
}

}  // namespace formula_number

// variables: as in the formula's parse(). Cost: in proportion to its nodes.
template <class Value>
Value formula_number_of(const expr::Formula& formula, std::span<const Value> variables) {
    using expr::Op;
    namespace f = formula_number;
    std::vector<Value> at;
    at.reserve(formula.nodes().size());
    for (const expr::Formula::Node& n : formula.nodes()) {
        const auto x = [&](std::size_t i) -> const Value& { return at[static_cast<std::size_t>(n.arguments[i])]; };
        const auto length = [](const Value& squared) { return squared.value > 0 ? sqrt(squared) : Value(0.0); };
        const auto value = [&]() -> Value {
            switch (n.op) {
                case Op::kNumber: return Value(n.number);
                case Op::kVariable: return variables[n.variable];
                case Op::kAdd: return f::bounded(x(0) + x(1));
                case Op::kSubtract: return f::bounded(x(0) - x(1));
                case Op::kMultiply: return f::bounded(x(0) * x(1));
                case Op::kDivide: return f::quotient(x(0), x(1));
                case Op::kPower: return f::power(x(0), formula.nodes()[static_cast<std::size_t>(n.arguments[1])], x(1));
                case Op::kNegate: return -x(0);
                case Op::kSin: return sin(x(0));
                case Op::kCos: return cos(x(0));
                case Op::kTan: return f::quotient(sin(x(0)), cos(x(0)));
                case Op::kAtan: return atan(x(0));
                case Op::kAtan2: {
                    Value angle = atan(f::quotient(x(0), x(1)));  // its derivatives
                    angle.value = std::atan2(x(0).value, x(1).value);
                    return angle;
                }
                case Op::kSqrt: return length(x(0));
                case Op::kAbs: return x(0).value < 0 ? -x(0) : x(0);
                case Op::kExp: return exp(f::clamped(x(0), Value(-69.0), Value(69.0)));
                case Op::kLog: return log(x(0).value < expr::kSmallest ? Value(expr::kSmallest) : x(0));
                case Op::kMin: return x(0).value < x(1).value ? x(0) : x(1);
                case Op::kMax: return x(0).value > x(1).value ? x(0) : x(1);
                case Op::kClamp: return f::clamped(x(0), x(1), x(2));
                case Op::kMix: return x(0) + (x(1) - x(0)) * x(2);
                case Op::kStep: return Value(x(1).value < x(0).value ? 0.0 : 1.0);
                case Op::kSmoothstep: return f::smooth_step(x(0), x(1), x(2));
                case Op::kFloor: return Value(std::floor(x(0).value));
                case Op::kMod: return x(0) - std::floor(f::quotient(x(0), x(1)).value) * x(1);
                case Op::kLength2: return length(x(0) * x(0) + x(1) * x(1));
                case Op::kLength3: return length(x(0) * x(0) + x(1) * x(1) + x(2) * x(2));
                case Op::kNoise1:
                case Op::kNoise2:
                case Op::kNoise3: break;
            }
            return Value(0.0);
        };
        at.push_back(value());
    }
    return at.back();
}

}  // namespace nullscope
