// Keys of what a thermal disc shines by.
#pragma once
#include <vector>

#include "scene/scene_key.h"

namespace nullscope {

std::vector<SceneKey> emissivity_keys();

}  // namespace nullscope
