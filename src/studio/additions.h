// What a user adds to a scene, where it is seen.
#pragma once
#include <string_view>

#include "base/result.h"
#include "scene/scene.h"

namespace nullscope::viewer {

// The part of the picture that no panel covers: shares of its width and height, from the top left.
struct FreePart {
    double left = 0.0, right = 1.0, top = 0.0, bottom = 1.0;
};

// The scene with one more section of this name; a ball becomes a planet in front of the camera, in the free part of the picture (unless light
// is bent or aberrated far from there), beside those that are there, of a size and a colour of its own, lit from one side. Errors: as a
// scene file's.
Result<Scene> with_addition(const Scene& scene, std::string_view section, const FreePart& free = {});

}  // namespace nullscope::viewer
