// Formulas: whatever the text, a formula with a finite value everywhere and GLSL of bounded length, or one line that says why not.
#include <cmath>

#include "expr/formula.h"
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace nullscope;
    const auto formula = expr::Formula::parse(fuzz::text_of(data, size), {"x", "y", "z", "u", "v"});
    if (!formula) {
        fuzz::must_be_a_good_error(formula.error());
        fuzz::must(formula.error().message().starts_with("column "), "the place is named");
        return 0;
    }
    fuzz::must(!formula->nodes().empty() && formula->nodes().size() <= expr::kMostNodes, "as large as is allowed");
    fuzz::must(formula->glsl("value").size() <= 100 * expr::kMostNodes, "its GLSL is bounded");
    for (const double at : {0.0, 1.0, -1.0, 0.37, 1e-300, 1e30, -1e30}) {
        const double values[] = {at, -at, 2.0, at * 0.5, 1.0 - at};
        const double value = formula->value(values);
        fuzz::must(std::isfinite(value) && std::abs(value) <= 1.0001 * expr::kLargest, "a finite value");
    }
    return 0;
}
