// Baselines as a table (CSV): columns u and v in wavelengths, and if one likes time_h and frequency_ghz, which are handed on.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "telescope/visibility.h"

namespace nullscope {

inline constexpr std::size_t kMostBaselines = 2'000'000;

struct BaselineList {
    std::vector<Baseline> baselines;
    std::vector<double> time_h, frequency_ghz;  // empty, or of each
    std::vector<int> lines;                     // of the file
};

// Errors (bad input): file, line and column of the first fault; frequency: the light's, where it has one, which each line has to have, GHz.
Result<BaselineList> read_baselines(std::string_view text, const std::string& file, std::optional<double> frequency);

}  // namespace nullscope
