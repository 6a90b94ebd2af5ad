#include "expr/smooth.h"

#include <fmt/format.h>

namespace nullscope::expr {
Result<SmoothFormula> SmoothFormula::parse(std::string_view text, const std::string& variable) {
    TRY(formula, Formula::parse(text, {variable}));
    SmoothFormula smooth;
    smooth.nodes_ = formula->nodes();
    for (std::size_t i = 0; i < smooth.nodes_.size(); ++i) {
        const Formula::Node node = smooth.nodes_[i];
        const OpRow& row = row_of(node.op);
        if (!row.smooth)
            return bad_input(fmt::format("{}{} is not smooth", row.name, node.op == Op::kAtan2 ? " of two" : ""));
        bool constant = node.op != Op::kVariable && node.op != Op::kNumber;
        SmoothFormula alone;  // this operation, of numbers
        for (std::size_t a = 0; a < row.arguments && constant; ++a) {
            const Formula::Node& argument = smooth.nodes_[static_cast<std::size_t>(node.arguments[a])];
            constant = argument.op == Op::kNumber;
            alone.nodes_.push_back(argument);
        }
        if (!constant) continue;
        alone.nodes_.push_back({node.op, {0, 1, 2}, 0, 0});
        smooth.nodes_[i] = {Op::kNumber, {}, alone.value<double>(0.0), 0};
    }
    return smooth;
}

}  // namespace nullscope::expr
