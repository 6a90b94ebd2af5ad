// Where a metric that is given by formulas has what a spacetime of holes has: its horizons and its photon sphere, or why it has none.
#pragma once
#include "spacetime/metric_formulas.h"
#include "spacetime/potential_panels.h"

namespace nullscope {

// In zeta = 1/r.
struct FormulaPlaces {
    static constexpr double kFarthest = 1e6, kNearest = 1e-3;  // r between which they are looked for
    double horizon = 0.0;        // the outermost zero of A that static observers see below them
    double outer_horizon = 0.0;  // the cosmological one; 0: there is none
    double v_at_sky = 0.0;       // V(0): minus a third of the cosmological constant
    double end = 0.0;            // where V has fallen to that again: the horizon, or behind it where v_at_sky < 0
    double photon = 0.0;         // where V is greatest
};

// Errors: of the key of one formula. Forgets B and R of the formulas where they are 1/A and r.
Result<FormulaPlaces> find_places(MetricFormulas& formulas, const Expansion& v_far, const Expansion& density_far);

}  // namespace nullscope
