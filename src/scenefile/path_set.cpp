#include "scenefile/path_set.h"

#include <fmt/format.h>

#include <algorithm>

#include "scenefile/path_values.h"
#include "scenefile/scene_value.h"

namespace nullscope {
namespace {

constexpr std::size_t kMostKeyed = 64;

void add_named(const toml::table& table, const std::string& before, std::vector<NamedValue>& found) {
    for (const auto& [name, node] : table) {
        const std::string full = before.empty() ? std::string(name.str()) : fmt::format("{}.{}", before, name.str());
        if (const toml::table* inner = node.as_table())
            add_named(*inner, full, found);
        else
            found.push_back({full, static_cast<int>(name.source().begin.line), &node});
    }
}

}  // namespace

std::vector<NamedValue> named_values(const toml::table& table) {
    std::vector<NamedValue> found;
    add_named(table, "", found);
    return found;
}

Status add_path_value(Scene& scene, PathKey& key, const NamedValue& one, const SceneFolders& folders) {
    PathSpec& path = *scene.path;
    TRY(value, path_value(scene, one.name));
    const auto number = check_value(value->key, *one.node, folders);
    if (!number) return bad_input(number.error().what, allowed_text(value->key));
    const auto place = std::ranges::lower_bound(path.keyed, one.name);
    const auto at = place - path.keyed.begin();
    if (place != path.keyed.end() && *place == one.name) {
        key.values[static_cast<std::size_t>(at)] = number->number;
        return Done{};
    }
    if (path.keyed.size() >= kMostKeyed)
        return bad_input("one too many", fmt::format("{} names in a path", kMostKeyed));
    const auto own = number_of(scene, *value);
    if (!own && !path.keys.empty())
        return bad_input("the scene has no value for the keys before", "a value in [[path.key]] from the first on");
    for (PathKey& earlier : path.keys) earlier.values.insert(earlier.values.begin() + at, *own);
    key.values.insert(key.values.begin() + at, number->number);
    path.keyed.insert(place, one.name);
    return Done{};
}

}  // namespace nullscope
