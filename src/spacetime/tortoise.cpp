#include "spacetime/tortoise.h"

#include <cmath>

#include "spacetime/axial_metric.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {

double time_ahead(const Spacetime& spacetime, double r) {
    const double zeta = 1.0 / r;
    if (const AxialMetric* metric = spacetime.axial()) {
        const double outer = metric->outer_horizon(), inner = metric->inner_horizon(), c = metric->charge2();
        return std::log(r) +
               ((outer - c) * std::log1p(-outer * zeta) - (inner - c) * std::log1p(-inner * zeta)) / (outer - inner);
    }
    const auto roots = spacetime.spherical()->lapse_roots();
    if (!roots) return 0.0;
    const double gap = roots->outer - roots->inner, without = 1.0 - roots->inner * zeta, by = gap * zeta / without;
    // ln((r - y)/(r - x))/(x - y).
    const double ratio = by > 0.0 ? -std::log1p(-by) / by * zeta / without : zeta / without;
    return (roots->outer + roots->inner) * std::log1p(-roots->outer * zeta) - roots->inner * roots->inner * ratio +
           std::log(r);
}

}  // namespace nullscope
