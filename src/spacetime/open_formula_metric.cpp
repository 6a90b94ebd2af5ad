#include "spacetime/open_formula_metric.h"

#include <cmath>

namespace nullscope {

Result<std::shared_ptr<const Spacetime>> OpenFormulaMetric::make(const MetricFormulas& formulas) {
    TRY(found, survey(formulas));
    return std::shared_ptr<const Spacetime>(new OpenFormulaMetric(formulas, std::move(*found)));
}

// Outside of where rays part: further in light can be trapped.
RadiusRange OpenFormulaMetric::camera_range() const {
    const RayPotential& p = survey_.potential;
    return {survey_.soft ? p.end() : p.end() + p.ridge().x, survey_.outer_horizon};
}

std::optional<PhotonSphere> OpenFormulaMetric::photon_sphere() const {
    if (survey_.soft || survey_.comes_back) return std::nullopt;
    const RayPotential& p = survey_.potential;
    return PhotonSphere{p.end() + p.ridge().x, std::sqrt(p.ridge().v)};
}

}  // namespace nullscope
