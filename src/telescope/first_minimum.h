// Where |V| is least for the first time along a line of baselines: of a ring its null.
#pragma once
#include <functional>
#include <optional>
#include <span>

#include "telescope/visibility.h"

namespace nullscope {

struct LeastVisibility {
    Baseline baseline;
    double amplitude = 0;  // of I there, in the picture's unit
};

// amplitude: |V| of any baseline. line: baselines in equal steps on a straight line, amplitudes: |V| of each. About the first of them that is less than the one before it and no more
// than the one after it, by golden sections: `sections` of them leave 0.618^sections of two steps. Nothing where there is none.
std::optional<LeastVisibility> first_minimum(const std::function<double(Baseline)>& amplitude,
                                             std::span<const Baseline> line, std::span<const double> amplitudes,
                                             int sections = 60);

}  // namespace nullscope
