// Derivatives of visibilities of a thermal disc, exact but for their quadrature (gradient/picture_visibility.h).
#pragma once
#include <span>
#include <vector>

#include "base/result.h"
#include "fit/free_parameters.h"
#include "fit/model.h"
#include "telescope/visibility.h"

namespace nullscope::fit {

// Of the visibilities over that of no baseline, by each parameter, in the unit of scene files: real and imaginary parts in turn, or magnitudes. Within 2 % of
// each one's length for fringes of up to 30 rad across the disc's radius. Errors: a parameter that is none of `nullscope flux --derivatives`; other light than
// that of a thermal disc which is whole in the picture; a gas, whose clumps have no derivatives here. Cost: gradient/picture_visibility.h.
Result<std::vector<Prediction>> visibility_slopes(const SceneFamily& family, const std::vector<double>& values,
                                                  std::span<const Baseline> baselines, bool is_complex);

}  // namespace nullscope::fit
