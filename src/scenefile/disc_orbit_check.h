// Whether a disc's matter can go round as a scene has it: held by the hole as far as the disc reaches, and about a rotating one about an axis
// that leans.
#pragma once
#include <vector>

#include "scene/scene.h"
#include "scene/scene_fault.h"
#include "spacetime/spacetime.h"

namespace nullscope {

// About a rotating hole also what does not go together with a disc that leans.
std::vector<SceneFault> disc_orbit_faults(const Spacetime& spacetime, const Scene& scene);

}  // namespace nullscope
