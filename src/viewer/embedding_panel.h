// The embedding diagram over the picture: studio/embedding.h, seen obliquely from above.
#pragma once
#include <string>

#include "scene/scene.h"
#include "viewer/probe.h"

namespace nullscope::viewer {

inline constexpr const char* kEmbeddingHelp =
    "Embedding diagram: the equatorial plane as a curved surface, with the camera, the photon sphere, the ISCO and the "
    "probe's ray.";

std::string no_embedding(const Scene& scene);  // why there is none, or nothing

// In the lower left corner of what lies between `left` and `right` above `bottom`; nothing where that is too narrow. ray: of the probe, in
// this scene's spacetime, or nullptr. Between NewFrame and Render. Returns where it begins at the top.
float draw_embedding(const Scene& scene, const ProbeFacts* ray, float left, float right, float bottom);

}  // namespace nullscope::viewer
