#include "scenefile/key_place.h"

#include <algorithm>
#include <cstdlib>

#include "base/atomic_file.h"
#include "scenefile/override_table.h"
#include "scenefile/sections.h"
#include "scenefile/toml_text.h"

namespace nullscope {
namespace {

// The key of a parsed file, or the section or section's list that it would be in; nullptr: neither. "ball[2].radius" is of the second [[ball]].
const toml::node* node_of(const toml::table& root, const std::string& key) {
    const toml::node* found = nullptr;
    const toml::table* table = &root;
    for (std::string_view rest = key; !rest.empty() && table != nullptr;) {
        const std::string_view part = rest.substr(0, rest.find('.'));
        rest.remove_prefix(std::min(part.size() + 1, rest.size()));
        const std::size_t bracket = part.find('[');
        const toml::node* node = table->get(part.substr(0, bracket));
        if (node == nullptr) break;
        found = node;
        table = node->as_table();
        if (const toml::array* list = node->as_array()) {  // "ball" is the first
            const int written = bracket == part.npos ? 1 : std::atoi(std::string(part.substr(bracket + 1)).c_str());
            const auto number = static_cast<std::size_t>(std::max(written, 1));
            if (const toml::node* entry = list->get(number - 1)) found = entry, table = entry->as_table();
        }
    }
    return found;
}

}  // namespace

Error placed_in_scene(Error error, const std::filesystem::path& file, const SceneOverrides& overrides) {
    const auto is_of = [&](const Section& section) {
        return error.key == section.name || error.key.starts_with(std::string(section.name) + ".") ||
               error.key.starts_with(std::string(section.name) + "[");
    };
    if (error.key.empty() || !error.file.empty() || std::ranges::none_of(sections(), is_of)) return error;
    if (auto given = error_of_override(error, overrides)) return *given;
    const auto text = read_text(file, kLargestSceneFile);
    if (!text) return error;
    const auto root = toml_of(*text, file.string());
    if (!root) return error;
    const toml::node* node = node_of(*root, error.key);
    if (auto given = error_of_section(error, overrides); given && node == nullptr) return *given;
    error.file = file.string();
    if (node != nullptr) error.line = static_cast<int>(node->source().begin.line);
    return error;
}

}  // namespace nullscope
