// Keys of a disc's warp and of its rings.
#pragma once
#include <vector>

#include "scene/scene_key.h"

namespace nullscope {

std::vector<SceneKey> disc_shape_keys();

}  // namespace nullscope
