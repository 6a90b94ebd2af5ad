#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "expr/formula.h"

namespace nullscope::expr {
namespace {

std::string literal(double value) {
    if (std::abs(value) < 1e-37) return "0.0";  // below what a float holds
    std::string text = fmt::format("{:.9g}", value);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return value < 0 ? "(" + text + ")" : text;
}

std::string_view pattern_of(Op op) {
    switch (op) {
        case Op::kAdd: return "expression_bounded({0} + {1})";
        case Op::kSubtract: return "expression_bounded({0} - {1})";
        case Op::kMultiply: return "expression_bounded({0} * {1})";
        case Op::kDivide: return "expression_divide({0}, {1})";
        case Op::kPower: return "expression_power({0}, {1})";
        case Op::kNegate: return "-{0}";
        case Op::kSin: return "sin(expression_turn({0}))";
        case Op::kCos: return "cos(expression_turn({0}))";
        case Op::kTan: return "expression_divide(sin(expression_turn({0})), cos(expression_turn({0})))";
        case Op::kAtan: return "expression_atan({0}, 1.0)";
        case Op::kAtan2: return "expression_atan({0}, {1})";
        case Op::kSqrt: return "sqrt(max({0}, 0.0))";
        case Op::kAbs: return "abs({0})";
        case Op::kExp: return "exp(clamp({0}, -69.0, 69.0))";
        case Op::kLog: return "log(max({0}, 1.0e-30))";
        case Op::kMin: return "min({0}, {1})";
        case Op::kMax: return "max({0}, {1})";
        case Op::kClamp: return "min(max({0}, {1}), {2})";
        case Op::kMix: return "expression_mix({0}, {1}, {2})";
        case Op::kStep: return "({1} < {0} ? 0.0 : 1.0)";
        case Op::kSmoothstep: return "expression_smooth({0}, {1}, {2})";
        case Op::kFloor: return "floor({0})";
        case Op::kMod: return "expression_mod({0}, {1})";
        case Op::kLength2: return "expression_length(vec3({0}, {1}, 0.0))";
        case Op::kLength3: return "expression_length(vec3({0}, {1}, {2}))";
        case Op::kNoise1: return "expression_noise(vec3({0}, 0.0, 0.0))";
        case Op::kNoise2: return "expression_noise(vec3({0}, {1}, 0.0))";
        case Op::kNoise3: return "expression_noise(vec3({0}, {1}, {2}))";
        case Op::kNumber:
        case Op::kVariable: break;
    }
    return "";
}

}  // namespace

// One statement a node: no nesting for a driver's parser to run out of.
std::string Formula::glsl(std::string_view result) const {
    std::string text;
    const auto name = [](int node) { return fmt::format("e{}", node); };
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const Node& n = nodes_[i];
        std::string value;
        if (n.op == Op::kNumber) {
            value = literal(n.number);
        } else if (n.op == Op::kVariable) {
            value = variables_[n.variable];
        } else if (const Node& exponent = nodes_[static_cast<std::size_t>(n.arguments[1])];
                   n.op == Op::kPower && exponent.op == Op::kNumber && is_whole(exponent.number)) {
            const int power = static_cast<int>(exponent.number);
            value = fmt::format("expression_whole_power({}, {})", name(n.arguments[0]), std::abs(power));
            if (power < 0) value = fmt::format("expression_divide(1.0, {})", value);
        } else {
            value = fmt::format(fmt::runtime(pattern_of(n.op)), name(n.arguments[0]), name(n.arguments[1]),
                                name(n.arguments[2]));
        }
        text += fmt::format("    float e{} = {};\n", i, value);
    }
    return text + fmt::format("    float {} = e{};\n", result, nodes_.size() - 1);
}

}  // namespace nullscope::expr
