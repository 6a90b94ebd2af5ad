#pragma once
#include <string>

#include "base/result.h"
#include "scene/scene.h"

namespace nullscope::cli {

// Isoradials of a scene's camera as SVG: the direct images of rings of 3, 5, 10 and 15 r_s (6, 10, 20 and 30 M, as in Luminet's figure of
// 1979) and the next ones, by the reference. Errors: as reference::isoradial.
Result<std::string> isoradials_svg(const Scene& scene);

}  // namespace nullscope::cli
