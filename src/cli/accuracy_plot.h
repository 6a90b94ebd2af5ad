// The work-precision diagram: screen error against cost, both logarithmic, as SVG.
#pragma once
#include <string>
#include <vector>

namespace nullscope::cli {

struct PlotPoint {
    std::string label,
        family;  // family: strip, table, closed-form, integrate, euler; mino:6, mino:4, kerr-schild: one colour each
    double cost, error;  // core-seconds; px of a 4K frame, maximum
    bool on_frontier, is_default;
};

std::string accuracy_svg(const std::vector<PlotPoint>& points, double floor_cost, const std::string& subtitle);

}  // namespace nullscope::cli
