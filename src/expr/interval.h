// Bounds of a formula's value over a box of its variables (interval arithmetic: R. E. Moore, Interval Analysis, 1966).
#pragma once
#include <span>

#include "expr/formula.h"

namespace nullscope::expr {

struct Interval {
    double low, high;  // low <= high
};

// Contains formula.value(x) of every x in the box, and is wider where a variable occurs more than once: in proportion to the box. values:
// of the variables, in their order. Cost: some five times Formula::value.
Interval range(const Formula& formula, std::span<const Interval> values);

}  // namespace nullscope::expr
