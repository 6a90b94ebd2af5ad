// The hard places of rotating holes, with and without charge: a part of hard_cases().
#pragma once
#include <vector>

#include "compare/hard_cases.h"

namespace nullscope {

std::vector<HardCase> hard_rotating_cases();

}  // namespace nullscope
