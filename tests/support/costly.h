// TEST_CASE("name" * costly()): a case that costs more than a base second at quick depth (support/depth.h).
#pragma once
#include <doctest/doctest.h>

#include "support/depth.h"

namespace nullscope::test {

inline doctest::skip costly(const char* file = __builtin_FILE()) { return doctest::skip(left_to_another_run(file)); }

}  // namespace nullscope::test
