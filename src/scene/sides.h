// The two sides of a wormhole: what may stand there, and what has no side.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"

namespace nullscope {

class Spacetime;

struct SideFault {
    std::string key;  // full name, or a section's
    std::string what, allowed;
};

// Of a wormhole: objects that reach across its throat or are not followed there. Of other metrics: bodies on a far side.
std::vector<SideFault> side_faults(const Spacetime& spacetime, const Scene& scene);
// The first of them, in a wormhole: where a scene is put into another metric, to compare with, all its bodies are on the one side.
Status check_sides(const Spacetime& spacetime, const Scene& scene);

}  // namespace nullscope
