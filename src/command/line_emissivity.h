// What the discs of line profiles shine by: spectrum's --emissivity.
#pragma once
#include <string>

#include "base/result.h"
#include "scene/scene.h"

namespace nullscope::cli {

inline constexpr const char* kEmissivityForms =
    "q of r^-q from -20 to 20; Q:R:Q or Q:R:Q:R:Q, powers and the radii of breaks between them; thermal; lamp:HEIGHT "
    "or "
    "lamp:HEIGHT:INDEX; a table FILE.csv";

// text empty: the scene's disc's, where it is thermal and shines by something else than accretion, or r^-3. Errors: not one of the forms.
Result<EmissivitySpec> line_emissivity(const std::string& text, const Scene& scene);

// Of a disc from inner to outer what shines: a table may end before. Errors: nothing does, a table that cannot be read, a lamp that cannot be at rest.
Status lit_part(const EmissivitySpec& spec, const Spacetime& spacetime, double& inner, double& outer);

}  // namespace nullscope::cli
