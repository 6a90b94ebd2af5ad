// What is said of a fit: a table for people, JSON for programs.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "command/json.h"
#include "fit/fitter.h"

namespace nullscope::fit {

struct Reported {
    const Fitted& fitted;
    const std::vector<FreeParameter>& free;
    std::string data;            // Observed::what
    std::optional<int> samples;  // Subject::samples
    bool free_flux = false;
};
// Best values with 68 % intervals (a standard deviation to either side), correlations, chi^2; of a bad fit the values without intervals;
// whether derivatives were exact, and if not, why.
std::string fit_table(const Reported& reported);
// "this scene does not describe the data: ..."; empty: it does.
std::string bad_words(const Goodness& goodness);
cli::Json fit_json(const Reported& reported);

}  // namespace nullscope::fit
