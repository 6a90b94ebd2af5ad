// A formula of one variable that is smooth: its value in any arithmetic that has +, -, *, / and the functions, such as long double or
// Series (series.h), which gives derivatives and expansions.
//
// Nothing is clamped here, as Formula::value does: a value that does not exist is not finite.
#pragma once
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "expr/formula.h"
#include "expr/series.h"

namespace nullscope::expr {

inline double power_of(double base, double exponent) { return std::pow(base, exponent); }
inline long double power_of(long double base, long double exponent) { return std::pow(base, exponent); }

// By squaring, so that a power of a series begins with that power of its first term, and of a number has few roundings.
template <class Value>
Value whole_power(Value base, int exponent, const Value& one) {
    Value result = one;
    for (int left = exponent < 0 ? -exponent : exponent; left > 0; left /= 2) {
        if (left % 2 == 1) result = result * base;
        base = base * base;
    }
    return exponent < 0 ? one / result : result;
}

class SmoothFormula {
public:
    // Errors (without file and key): what Formula::parse refuses; a function that has no derivative everywhere: abs, min, max, clamp,
    // step, smoothstep, floor, mod, noise, atan of two.
    static Result<SmoothFormula> parse(std::string_view text, const std::string& variable);

    // Value(Real) makes a constant. Cost: one operation a node.
    template <class Real, class Value>
    Value value(const Value& variable) const;

private:
    std::vector<Formula::Node> nodes_;  // what has no variable in it is a number
};

template <class Real, class Value>
Value SmoothFormula::value(const Value& variable) const {
    using std::atan;
    using std::cos;
    using std::exp;
    using std::log;
    using std::sin;
    using std::sqrt;
    // Nearly all formulas are short, and millions of values are asked for: no memory from the heap for them.
    constexpr std::size_t kShort = 32;
    std::array<Value, kShort> few;
    std::vector<Value> many;
    Value* at = few.data();
    if (nodes_.size() > kShort) many.resize(nodes_.size()), at = many.data();
    Value* next = at;
    const auto constant = [](double x) { return Value(static_cast<Real>(x)); };
    for (const Formula::Node& n : nodes_) {
        const auto argument = [&](std::size_t i) -> const Value& {
            return at[static_cast<std::size_t>(n.arguments[i])];
        };
        const auto power = [&] {
            const Formula::Node& exponent = nodes_[static_cast<std::size_t>(n.arguments[1])];
            if (exponent.op != Op::kNumber) return exp(argument(1) * log(argument(0)));
            if (is_whole(exponent.number))
                return whole_power(argument(0), static_cast<int>(exponent.number), constant(1));
            return power_of(argument(0), static_cast<Real>(exponent.number));
        };
        switch (n.op) {
            case Op::kNumber: *next++ = constant(n.number); break;
            case Op::kVariable: *next++ = variable; break;
            case Op::kAdd: *next++ = argument(0) + argument(1); break;
            case Op::kSubtract: *next++ = argument(0) - argument(1); break;
            case Op::kMultiply: *next++ = argument(0) * argument(1); break;
            case Op::kDivide: *next++ = argument(0) / argument(1); break;
            case Op::kPower: *next++ = power(); break;
            case Op::kNegate: *next++ = -argument(0); break;
            case Op::kSin: *next++ = sin(argument(0)); break;
            case Op::kCos: *next++ = cos(argument(0)); break;
            case Op::kTan: *next++ = sin(argument(0)) / cos(argument(0)); break;
            case Op::kAtan: *next++ = atan(argument(0)); break;
            case Op::kSqrt: *next++ = sqrt(argument(0)); break;
            case Op::kExp: *next++ = exp(argument(0)); break;
            case Op::kLog: *next++ = log(argument(0)); break;
            case Op::kMix: *next++ = argument(0) + (argument(1) - argument(0)) * argument(2); break;
            case Op::kLength2: *next++ = sqrt(argument(0) * argument(0) + argument(1) * argument(1)); break;
            case Op::kLength3:
                *next++ = sqrt(argument(0) * argument(0) + argument(1) * argument(1) + argument(2) * argument(2));
                break;
            default: *next++ = constant(std::numeric_limits<double>::quiet_NaN()); break;
        }
    }
    return next[-1];
}

}  // namespace nullscope::expr
