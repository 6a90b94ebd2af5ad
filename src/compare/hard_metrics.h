// The hard places of every metric but Schwarzschild: a part of hard_cases().
#pragma once
#include <vector>

#include "compare/hard_cases.h"

namespace nullscope {

std::vector<HardCase> hard_metric_cases();

}  // namespace nullscope
