// Inside scenefile only: [[path.key]] set = { "spacetime.spin" = 0.5, disc.outer = 8 }, as it is read.
#pragma once
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "base/result.h"
#include "scene/scene.h"
#include "scenefile/scene_folders.h"

namespace nullscope {

struct NamedValue {
    std::string name;  // "spacetime.spin", whether it was written in quotes or as a table in a table
    int line;
    const toml::node* node;
};
std::vector<NamedValue> named_values(const toml::table& table);

// To a key that scene.path does not have yet; names are in the order of the alphabet. A name that no key has had is the scene's number in those before. Errors, without file and line: as
// path_value()'s, another kind, out of range, one name too many.
Status add_path_value(Scene& scene, PathKey& key, const NamedValue& value, const SceneFolders& folders);

}  // namespace nullscope
