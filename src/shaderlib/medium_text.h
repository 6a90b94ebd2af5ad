// The shader's text for matter by formula (shaders/medium/formula.glsl).
#pragma once
#include <string>

#include "scene/scene.h"

namespace nullscope {

// medium_matter and what it calls; FIELD_DIRECTION. Empty where there is no such matter. Formulas must be valid.
std::string medium_text(const Scene& scene);

}  // namespace nullscope
