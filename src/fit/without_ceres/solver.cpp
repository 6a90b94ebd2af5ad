#include "fit/solver.h"

namespace nullscope::fit {

bool can_solve() { return false; }

Result<Solution> solve(const Problem&, const std::vector<double>&, const Steps&) {
    return failed("fits need Ceres Solver, without which this program was built");
}

}  // namespace nullscope::fit
