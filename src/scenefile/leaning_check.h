// What does not go together with a disc that leans about a rotating hole.
#pragma once
#include <vector>

#include "scene/scene.h"
#include "scene/scene_fault.h"
#include "spacetime/spacetime.h"

namespace nullscope {

// None where it does not lean or nothing rotates.
std::vector<SceneFault> leaning_faults(const Spacetime& spacetime, const Scene& scene);

}  // namespace nullscope
