// The shader's text for matter along rays: what its model (shaders/medium) is told by the scene, and its emission law.
#pragma once
#include <string>

#include "scene/scene.h"

namespace nullscope {

// generated/medium_matter: names of the numbers of model and law; COLDEST_K, FIELD_DIRECTION; medium_temperature() and medium_field() where
// the model has none and the law asks for them; of kFormula formula_matter(). Empty where there is no matter. Formulas must be valid.
std::string medium_text(const Scene& scene);
// generated/medium_law: the law's file.
std::string medium_law_text(const Scene& scene);

}  // namespace nullscope
