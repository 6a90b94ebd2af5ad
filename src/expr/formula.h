// Formulas of scene files (docs/expressions.md): a bounded language of numbers, parsed from memory, evaluated in double and
// written out as GLSL. No loops, no names but those given, no way to the host.
//
// Every operation has a value for every input: results are clamped to +-kLargest, divisors kept off 0, roots and logarithms
// taken of what is positive. shaders/effect/expression.glsl says the same in GLSL; a test compares the two.
#pragma once
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
