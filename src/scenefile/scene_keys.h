// The keys of a scene file: the one table that the reader checks against, that errors quote and that docs/scenes.md
// shows. A key is added by one row (and its line in docs/scenes.md, which a test asks for), here or with the Feature that it belongs
// to (plan/feature.h). The parameters of a metric are not here: they come from the registry of spacetimes and are keys of
// [spacetime] too.
#pragma once
#include <span>
#include <string_view>

#include "scene/scene_key.h"

namespace nullscope {

// What this program reads and writes. A file that does not say is of format 1; a format is new where an old file would mean something else
// by the new rules, not where keys are added.
inline constexpr int kSceneFormat = 1;

std::span<const SceneKey> scene_keys();
KeyRange key_range(std::string_view full_name);  // of a key that the program names

}  // namespace nullscope
