// Which method a wish comes to in a scene, in words for the panel.
#pragma once
#include <string>
#include <vector>

#include "shaderlib/frontier.h"
#include "studio/view_state.h"

namespace nullscope::viewer {

struct MethodChoice {
    Method method;
    bool kept = true;  // false: nothing measured is that exact; method is then the most exact there is
    std::string words;
};

// What every method errs and costs: the frontier that ships.
struct MethodTable {
    std::vector<MeasuredMethod> measured;
    std::string not_measured;  // why it could not be read, or nothing
};
MethodTable shipped_methods();

// measured: of load_frontier; empty where that failed.
MethodChoice method_choice(const std::vector<MeasuredMethod>& measured, const MethodWish& wish, const Scene& scene);

// The row of a method in a metric; nullptr if it was not measured.
const MeasuredMethod* row_of(const std::vector<MeasuredMethod>& measured, const Method& method,
                             const std::string& metric);

}  // namespace nullscope::viewer
