// Which body a pixel shows, by the reference tracer. No window, no OpenGL.
#pragma once
#include <cstddef>
#include <optional>

#include "scene/scene.h"

namespace nullscope::viewer {

// Of scene.bodies the one that the ray through pixel position (x, y), from the picture's top left, meets first, in the half that shows it.
// Nothing where it meets none, or an opaque disc before it. A millisecond, some more about a rotating hole.
std::optional<std::size_t> body_at(const Scene& scene, double x, double y);

}  // namespace nullscope::viewer
