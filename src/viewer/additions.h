// What a user adds to a scene, where it is seen.
#pragma once
#include <string_view>

#include "base/result.h"
#include "scene/scene.h"

namespace nullscope::viewer {

// The scene with one more section of this name; a ball becomes a planet in front of the camera, beside those that are there, of a size and a
// colour of its own, lit from one side. Errors: as a scene file's.
Result<Scene> with_addition(const Scene& scene, std::string_view section);

}  // namespace nullscope::viewer
