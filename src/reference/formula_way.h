// Orbits in metrics by formula that are no holes in space that is flat far out: step by step (formula_way.cpp).
#pragma once
#include "reference/plane_metrics.h"

namespace nullscope::reference {

// Errors: formulas that cannot be read.
Result<std::unique_ptr<Metric>> make_formula_ways(const SpacetimeSpec& spec);

}  // namespace nullscope::reference
