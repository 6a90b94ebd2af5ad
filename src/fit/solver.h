// From a start to the nearest least of chi^2, by Levenberg and Marquardt's method with bounds and a robust loss (Ceres: only here).
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "fit/problem.h"

namespace nullscope::fit {

struct Solution {
    std::vector<double> values;  // in the unit of scene files
    double flux = 1, chi2 = 0;   // chi2: of plain squares, whatever the loss
    bool converged = false;
    std::vector<double> sigma{};        // standard deviations; empty: the data do not determine the parameters
    std::vector<double> correlation{};  // row by row
    std::vector<double>
        slope{};  // of the prediction by each parameter's share of its range: length in standard deviations of the data
    int predictions = 0;
    std::string why_differences{};                                             // Slopes::why_differences
    bool at_end(const std::vector<FreeParameter>& free, std::size_t i) const;  // of its range
};

Steps steps_at(const Solution& solution);

bool can_solve();  // false: built without Ceres (NULLSCOPE_FIT), and solve() fails

// Cost: each step 1 + 2 free.size() predictions, some 5 to 15 steps.
Result<Solution> solve(const Problem& problem, const std::vector<double>& start, const Steps& steps);

}  // namespace nullscope::fit
