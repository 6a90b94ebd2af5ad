// The two sides of a wormhole: what may stand there, and what has no side.
#pragma once
#include <vector>

#include "base/result.h"
#include "scene/scene.h"
#include "scene/scene_fault.h"

namespace nullscope {

class Spacetime;

// Of a wormhole: objects that reach across its throat or are not followed there. Of other metrics: bodies on a far side.
std::vector<SceneFault> side_faults(const Spacetime& spacetime, const Scene& scene);
// The first of them, in a wormhole: where a scene is put into another metric, to compare with, all its bodies are on the one side.
Status check_sides(const Spacetime& spacetime, const Scene& scene);

}  // namespace nullscope
