// Inside scene only: one value of a scene file against its row of the key table, and a file's words cut for messages.
#pragma once
#include <string>
#include <string_view>

#include <toml++/toml.h>

#include "base/result.h"
#include "scene/scene_key.h"
#include "scenefile/scene_folders.h"

namespace nullscope {

// Checks type, finiteness, range, known word, that the file exists. folders: what image paths are relative to.
// Errors: what is wrong, without file, line, key and allowed range.
Result<KeyValue> check_value(const SceneKey& key, const toml::node& node, const SceneFolders& folders);

}  // namespace nullscope
