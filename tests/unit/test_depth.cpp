// How costly cases are dealt to runs (support/depth.h).
#include "support/depth.h"

#include <doctest/doctest.h>

#include <string>

using namespace nullscope::test;

TEST_CASE("depth: as many runs as there are parts take each costly case once, and a run without a number all") {
    for (int number = 0; number < 13; ++number) {
        int taken = 0;
        for (int run = 8; run < 8 + kCostlyParts; ++run)
            taken += is_of_another_run(number, std::to_string(run)) ? 0 : 1;
        CHECK(taken == 1);
        CHECK_FALSE(is_of_another_run(number, ""));
    }
}
