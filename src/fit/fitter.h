// A whole fit: the search, at first of coarser data where there are these, and the answer with all data and as fine a model as it takes.
#pragma once
#include <functional>
#include <vector>

#include "base/result.h"
#include "fit/goodness.h"
#include "fit/search.h"

namespace nullscope::fit {

struct Fitted {
    Solution best;
    Goodness goodness;
    std::vector<Answer> answers;  // where starts led, best first
    int starts = 0, predictions = 0;
    double moved = 0;  // by the last refinement of the model: the most of any parameter, in its standard deviations
};
inline constexpr double kStays = 0.2;  // such a move is none

// coarse: another problem of the same parameters that costs less; null: there is none.
// finer: makes the problem's model finer, called until the answer stays; false: it cannot be finer.
Result<Fitted> run_fit(const Problem& problem, const Problem* coarse, const SearchOptions& options,
                       const std::function<bool()>& finer);

}  // namespace nullscope::fit
