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
            value = fmt::format(fmt::runtime(row_of(n.op).glsl), name(n.arguments[0]), name(n.arguments[1]),
                                name(n.arguments[2]));
        }
        text += fmt::format("    float e{} = {};\n", i, value);
    }
    return text + fmt::format("    float {} = e{};\n", result, nodes_.size() - 1);
}

}  // namespace nullscope::expr
