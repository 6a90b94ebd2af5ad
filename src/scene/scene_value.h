// Inside scene only: one value of a scene file against its row of the key table, and a file's words cut for messages.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>

#include <toml++/toml.h>

#include "scene/scene_keys.h"

namespace nullscope {

// What is wrong with a value; the reader adds file, line, key and the allowed range.
struct Fault {
    std::string what;
};

// Checks type, finiteness, range, known word, that the file exists. base: the folder that image paths are relative to.
std::variant<KeyValue, Fault> check_value(const SceneKey& key, const toml::node& node,
                                          const std::filesystem::path& base);

// A file's own words in quotes, cut at 60 bytes (at a character's boundary).
std::string in_quotes(std::string_view text);

}  // namespace nullscope
