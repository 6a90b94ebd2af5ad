// Whether a disc's warp and rings are such, and what does not go together with them.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/scene_fault.h"
#include "spacetime/spacetime.h"

namespace nullscope {

// world: the scene's spacetime, or nullptr where that is at fault itself. given: whether the file has a key.
std::vector<SceneFault> disc_shape_faults(const Spacetime* world, const Scene& scene,
                                          const std::function<bool(const std::string&)>& given);

}  // namespace nullscope
