// The statistics of a set of errors as JSON: {"max", "p999", "median"}, in the unit of the errors.
#pragma once
#include "command/json.h"
#include "compare/ray_errors.h"

namespace nullscope::cli {

inline Json spread_json(const Spread& s) { return {{"max", s.max}, {"p999", s.p999}, {"median", s.median}}; }

}  // namespace nullscope::cli
