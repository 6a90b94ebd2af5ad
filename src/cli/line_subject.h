// The profile of a line as the data of a fit: a table (CSV) as `nullscope spectrum` writes it, and what a scene's disc has in these bins.
#pragma once
#include <string>

#include "base/result.h"
#include "fit/free_parameters.h"
#include "fit/subject.h"

namespace nullscope::cli {

bool is_line_table(const std::string& file);  // its header has g_from

// Share of the line's photons in each bin. sigma: "" or what is in the place of the column noise: a number, or a number and % of the largest share.
// Errors (bad input): file, line and column of the first fault; bins that are not of one width, or do not lie one after the other.
Result<fit::Subject> line_subject(const fit::SceneFamily& family, const std::string& file, const std::string& sigma);

}  // namespace nullscope::cli
