// h(chi) of a metric (spacetime.h) as polynomials: the deflection table asks for it some 300 000 times, and a metric may have to invert
// a function for each.
//
// [0, pi] in 64 equal panels, of which the first and last are halved again and again towards their ends, where h need not be smooth
// (nearly extremal horizons; wormholes whose R holds l + ln l): degree 11 through Chebyshev's nodes. Error: below 1e-12 of the largest
// h for every metric of the registry (tests/unit/test_deflection_table.cpp). Some 1400 evaluations of h.
#pragma once
#include <array>
#include <vector>

#include "spacetime/spherical_metric.h"

namespace nullscope {

class DensityFit {
public:
    explicit DensityFit(const SphericalMetric& spacetime);
    double operator()(double chi) const;  // chi in [0, pi]

private:
    static constexpr int kPanels = 64, kHalvings = 30, kTerms = 12;
    struct Panel {
        double middle, per_half;       // t = (chi - middle) per_half in [-1, 1]
        std::array<double, kTerms> c;  // of powers of t
    };
    // Inner panels, then those towards 0, then those towards pi (in pi - chi).
    std::vector<Panel> inner_, first_, last_;
};

}  // namespace nullscope
