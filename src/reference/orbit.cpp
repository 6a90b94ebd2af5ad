#include "reference/orbit.h"

#include <algorithm>
#include <cmath>

namespace nullscope::reference {

double OrbitMetric::lapse2_slope(double r) const {
    double h = std::min(0.01 * r, 0.1 * (r - horizon_radius().value_or(0.0)));  // all of it outside
    while (h > 1e-12 * r && !std::isfinite(lapse(r - 4 * h))) h /= 2;           // of a star
    const auto d = [&](int n) { return lapse2(r + n * h) - lapse2(r - n * h); };
    return (d(1) * 4.0 / 5 - d(2) / 5 + d(3) * 4.0 / 105 - d(4) / 280) / h;
}

}  // namespace nullscope::reference
