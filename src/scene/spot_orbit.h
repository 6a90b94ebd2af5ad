// How long hot spots take for an orbit.
#pragma once
#include <optional>

#include "scene/scene.h"

namespace nullscope {

// Of the first hot spot, r_s/c; nothing: there is no spot, or no such orbit.
std::optional<double> spot_period(const Scene& scene);

}  // namespace nullscope
