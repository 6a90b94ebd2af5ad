// What in a scene depends on time.
#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

namespace nullscope {

// The keys that make something move, as a plan names them: "disc.flow", "spot.r". Empty: every time looks the same.
std::vector<std::string> moving_parts(const Scene& scene);

// The first of them, and how many more there are; empty where nothing moves.
std::string moving_words(const Scene& scene);

bool surface_moves(const SurfaceSpec& surface);  // whether its formula asks for t

}  // namespace nullscope
