// The profile of a line as the data of a fit: a table (CSV) as `nullscope spectrum` writes it, and what a scene's disc has in these bins.
#pragma once
#include <string>

#include "base/result.h"
#include "fit/data_sources.h"
#include "fit/free_parameters.h"

namespace nullscope::fit {

// Share of the line's photons in each bin.
// Errors (bad input): file, line and column of the first fault; bins that are not of one width, or do not lie one after the other.
Result<Subject> line_subject(const SceneFamily& family, const TableSource& source);

}  // namespace nullscope::fit
