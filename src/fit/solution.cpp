// What of solver.h needs no solver.
#include "fit/solver.h"

namespace nullscope::fit {
namespace {

constexpr double kEnd = 1e-4;  // of a range: what is nearer to an end is at it

}  // namespace

Steps steps_at(const Solution& solution) { return steps_for(solution.slope); }

bool Solution::at_end(const std::vector<FreeParameter>& free, std::size_t i) const {
    const double share = free[i].share(values[i]);
    return share < kEnd || share > 1 - kEnd;
}

}  // namespace nullscope::fit
