// Formulas of scene files (docs/expressions.md): a bounded language of numbers, parsed from memory, evaluated in double and
// written out as GLSL. No loops, no names but those given, no way to the host.
//
// Every operation has a value for every input: results are clamped to +-kLargest, divisors kept off 0, roots and logarithms
// taken of what is positive. shaders/effect/expression.glsl says the same in GLSL; a test compares the two.
#pragma once
#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace nullscope::expr {

inline constexpr std::size_t kLongest = 1000;   // bytes of a formula
inline constexpr std::size_t kMostNodes = 256;  // operands and operations
inline constexpr int kDeepest = 32;             // nesting of brackets, signs and powers
inline constexpr double kLargest = 1e30, kSmallest = 1e-30;
inline constexpr double kLargestAngle = 1e6;  // beyond it sin, cos and tan stand still: no digits are left of the angle
// A constant exponent that is computed by products, for bases of either sign; other powers take |base| that is 0 as 1e-30, and
// negative bases too.
inline bool is_whole(double exponent) {
    return exponent >= -16 && exponent <= 16 && exponent == static_cast<int>(exponent);
}

enum class Op {
    kNumber,
    kVariable,
    kAdd,
    kSubtract,
    kMultiply,
    kDivide,
    kPower,
    kNegate,
    kSin,
    kCos,
    kTan,
    kAtan,
    kAtan2,
    kSqrt,
    kAbs,
    kExp,
    kLog,
    kMin,
    kMax,
    kClamp,
    kMix,
    kStep,
    kSmoothstep,
    kFloor,
    kMod,
    kLength2,
    kLength3,
    kNoise1,
    kNoise2,
    kNoise3
};

// In the order of Op. name: of functions; smooth: whether it has all derivatives at all of its arguments; glsl: of what
// the arguments {0}, {1}, {2} are.
struct OpRow {
    Op op;
    std::string_view name;
    std::size_t arguments;
    bool smooth;
    std::string_view glsl;
};
inline constexpr OpRow kOps[] = {
    {Op::kNumber, "", 0, true, ""},
    {Op::kVariable, "", 0, true, ""},
    {Op::kAdd, "", 2, true, "expression_bounded({0} + {1})"},
    {Op::kSubtract, "", 2, true, "expression_bounded({0} - {1})"},
    {Op::kMultiply, "", 2, true, "expression_bounded({0} * {1})"},
    {Op::kDivide, "", 2, true, "expression_divide({0}, {1})"},
    {Op::kPower, "", 2, true, "expression_power({0}, {1})"},
    {Op::kNegate, "", 1, true, "-{0}"},
    {Op::kSin, "sin", 1, true, "sin(expression_turn({0}))"},
    {Op::kCos, "cos", 1, true, "cos(expression_turn({0}))"},
    {Op::kTan, "tan", 1, true, "expression_divide(sin(expression_turn({0})), cos(expression_turn({0})))"},
    {Op::kAtan, "atan", 1, true, "expression_atan({0}, 1.0)"},
    {Op::kAtan2, "atan", 2, false, "expression_atan({0}, {1})"},
    {Op::kSqrt, "sqrt", 1, true, "sqrt(max({0}, 0.0))"},
    {Op::kAbs, "abs", 1, false, "abs({0})"},
    {Op::kExp, "exp", 1, true, "exp(clamp({0}, -69.0, 69.0))"},
    {Op::kLog, "log", 1, true, "log(max({0}, 1.0e-30))"},
    {Op::kMin, "min", 2, false, "min({0}, {1})"},
    {Op::kMax, "max", 2, false, "max({0}, {1})"},
    {Op::kClamp, "clamp", 3, false, "min(max({0}, {1}), {2})"},
    {Op::kMix, "mix", 3, true, "expression_mix({0}, {1}, {2})"},
    {Op::kStep, "step", 2, false, "({1} < {0} ? 0.0 : 1.0)"},
    {Op::kSmoothstep, "smoothstep", 3, false, "expression_smooth({0}, {1}, {2})"},
    {Op::kFloor, "floor", 1, false, "floor({0})"},
    {Op::kMod, "mod", 2, false, "expression_mod({0}, {1})"},
    {Op::kLength2, "length", 2, true, "expression_length(vec3({0}, {1}, 0.0))"},
    {Op::kLength3, "length", 3, true, "expression_length(vec3({0}, {1}, {2}))"},
    {Op::kNoise1, "noise", 1, false, "expression_noise(vec3({0}, 0.0, 0.0))"},
    {Op::kNoise2, "noise", 2, false, "expression_noise(vec3({0}, {1}, 0.0))"},
    {Op::kNoise3, "noise", 3, false, "expression_noise(vec3({0}, {1}, {2}))"},
};
constexpr const OpRow& row_of(Op op) { return kOps[static_cast<std::size_t>(op)]; }
static_assert(std::ranges::all_of(kOps, [](const OpRow& row) { return &row == &row_of(row.op); }));

class Formula {
public:
    // variables: the names that may occur; pi is always known. Errors (without file and key): what is wrong and where, in bytes
    // from 1. Cost: in proportion to the text.
    static Result<Formula> parse(std::string_view text, const std::vector<std::string>& variables);

    // values: of the variables, in their order. Finite for finite values.
    double value(std::span<const double> values) const;
    // Statements that leave the value in `float result`; variables are the names given to parse.
    std::string glsl(std::string_view result) const;
    bool uses(std::size_t variable) const;

    struct Node {
        Op op = Op::kNumber;
        std::array<int, 3> arguments{};  // earlier nodes
        double number = 0;
        std::size_t variable = 0;
    };
    const std::vector<Node>& nodes() const { return nodes_; }  // the last one is the value

private:
    std::vector<Node> nodes_;
    std::vector<std::string> variables_;
};

// Value noise in [0, 1]: hashed lattice, smooth between. The same numbers everywhere.
double noise(double x, double y, double z);

}  // namespace nullscope::expr
