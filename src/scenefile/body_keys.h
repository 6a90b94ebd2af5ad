// Inside scene only: the rows of the key table that belong to solid bodies.
#pragma once
#include <vector>

#include "scene/scene_key.h"

namespace nullscope {

void append_body_keys(std::vector<SceneKey>& keys);

}  // namespace nullscope
