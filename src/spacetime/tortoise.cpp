#include "spacetime/tortoise.h"

#include <cmath>

#include "spacetime/spin_frame.h"

namespace nullscope {

double time_ahead(const Spacetime& spacetime, double r) {
    const double zeta = 1.0 / r;
    if (spacetime.spin() != 0.0) {
        const double outer = *spacetime.horizon_radius(), inner = inner_horizon(spacetime);
        return std::log(r) + (outer * std::log1p(-outer * zeta) - inner * std::log1p(-inner * zeta)) / (outer - inner);
    }
    const auto roots = spacetime.lapse_roots();
    if (!roots) return 0.0;
    const double gap = roots->outer - roots->inner, without = 1.0 - roots->inner * zeta, by = gap * zeta / without;
    const double ratio =
        by > 0.0 ? -std::log1p(-by) / by * zeta / without : zeta / without;  // ln((r - y)/(r - x))/(x - y)
    return (roots->outer + roots->inner) * std::log1p(-roots->outer * zeta) - roots->inner * roots->inner * ratio +
           std::log(r);
}

}  // namespace nullscope
