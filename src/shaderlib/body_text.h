// The shader's text for the solid bodies of a scene, its disc and sky: what depends on more than which effects are on (formulas, kinds of texture).
#pragma once
#include <string>

#include "scene/effects.h"
#include "scene/scene.h"

namespace nullscope {

// What generated/surface, bodies_march, bodies_hit, bodies_light and coats stand for where a shader includes them.
// Compared as a whole: two scenes with equal texts and equal effects have one program.
struct BodyText {
    std::string shape;  // surface_formula, and whether it knows the time
    std::string march;  // march_value, march_room, march_object, MARCH_MOST_STEPS
    std::string hit;    // solid_hit: the first body on the ray; about a rotating hole the tracer finds it
    std::string light;  // solid_light: and its light
    std::string coats;  // disc_coat_paint, dome_paint: what a disc and a sky without images are painted with
    friend auto operator<=>(const BodyText&, const BodyText&) = default;  // NOLINT(modernize-use-nullptr): no pointer
};

// effects: what the scene calls for. Empty for a scene without bodies whose disc and sky are not painted. Formulas must be valid (scene files are checked).
BodyText body_text(const Scene& scene, const EffectSet& effects);

}  // namespace nullscope
