// What A, B and R of formulas are like between the sky and where they end: where rays part, and where those go that pass.
#pragma once
#include <optional>

#include "base/result.h"
#include "spacetime/ray_potential.h"
#include "spacetime/spacetime.h"

namespace nullscope {

struct PotentialSurvey {
    RayPotential potential;             // about its ridge
    bool soft = false;                  // no ray winds anywhere: the ridge is where V is flattest
    bool comes_back = false;            // V grows without bound inward
    double trough = 0.0;                // x where V is least within the ridge, if light comes back from behind it
    std::optional<double> horizon;      // r; of a hole
    double outer_horizon = kAnyRadius;  // r
};

// Errors: of the key of one formula.
Result<PotentialSurvey> survey(const MetricFormulas& formulas);

}  // namespace nullscope
