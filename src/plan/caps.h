// Spheres that turn, and hot caps on them: what of a scene does not fit together.
#pragma once
#include <vector>

#include "scene/scene.h"
#include "scene/scene_fault.h"

namespace nullscope {

class Spacetime;

// A sphere that turns faster than light, or pulsates too; caps without a sphere that keeps its size, or on one without a temperature.
std::vector<SceneFault> cap_faults(const Spacetime& spacetime, const Scene& scene);

}  // namespace nullscope
