// V(zeta) of formulas as short Taylor series on equal panels: the orbit table asks for its slopes some 100 000 times a frame, each in a few
// nanoseconds instead of a microsecond.
#pragma once
#include <array>
#include <vector>

#include "spacetime/metric_formulas.h"

namespace nullscope {

struct Potential {
    double v, slope, curvature;  // by zeta
};

class PotentialPanels {
public:
    PotentialPanels() = default;
    PotentialPanels(const MetricFormulas& formulas, double end);              // of zeta in [0, end]
    Potential operator()(const MetricFormulas& formulas, double zeta) const;  // elsewhere from the formulas themselves

private:
    static constexpr int kPanels = 192, kTerms = 12;
    struct Panel {
        bool good = false;  // to a rounding of the largest term
        std::array<double, kTerms> c{};
    };
    double end_ = 0.0;
    std::vector<Panel> panels_;
};

}  // namespace nullscope
