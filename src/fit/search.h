// From ranges to the least of chi^2: many places are looked at, the best of them refined.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "fit/solver.h"

namespace nullscope::fit {

struct SearchOptions {
    int places = 96;                    // that are looked at; they fill the ranges evenly
    int starts = 4;                     // of them that are refined
    std::optional<std::uint64_t> seed;  // starts are random places in the ranges instead
    BeginProgress progress = progress_on_terminal;
};

// Where starts led.
struct Answer {
    Solution solution;
    int starts = 1;
};

struct Searched {
    std::vector<Answer> answers;  // best first
    int predictions = 0;          // that it took
};

// Best first. Answers are one where no parameter differs by more than a hundredth of its range or three standard deviations (up to a tenth of the range).
std::vector<Answer> distinct(const Problem& problem, std::vector<Answer> answers);

// Errors: no place can be predicted.
Result<Searched> search(const Problem& problem, const SearchOptions& options);

}  // namespace nullscope::fit
