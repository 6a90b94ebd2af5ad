// Inside scene only: one value of a scene file against its row of the key table, and a file's words cut for messages.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include <toml++/toml.h>

#include "base/result.h"
#include "scene/scene_key.h"

namespace nullscope {

// Checks type, finiteness, range, known word, that the file exists. base: the folder that image paths are relative to.
// Errors: what is wrong, without file, line, key and allowed range.
Result<KeyValue> check_value(const SceneKey& key, const toml::node& node, const std::filesystem::path& base);

}  // namespace nullscope
