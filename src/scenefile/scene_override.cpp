#include "scenefile/scene_override.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/text.h"
#include "scenefile/override_table.h"
#include "scenefile/toml_text.h"

namespace nullscope {
namespace {

constexpr std::size_t kMostParts = 4;  // of a key

Error bad_override(const std::string& words, const std::string& what, const std::string& allowed) {
    return without_controls(bad_input(fmt::format("--set {}: {}", words, what), allowed));
}

// "ball[2]": the name, and the place in the list, from 1; 0: it says none.
struct Part {
    std::string name;
    std::size_t place = 0;
};

std::optional<Part> part_of(const std::string& text) {
    const std::size_t open = text.find('[');
    if (open == std::string::npos) return Part{text};
    const auto place = text.back() == ']' ? parse_number(text.substr(open + 1, text.size() - open - 2)) : std::nullopt;
    if (!place || !(*place >= 1 && *place <= 1e6) || *place != static_cast<double>(static_cast<std::size_t>(*place)))
        return std::nullopt;
    return Part{text.substr(0, open), static_cast<std::size_t>(*place)};
}

// The section of that name in the table, made if there is none.
Result<toml::table*> section_in(toml::table& table, const Part& part, const std::string& words) {
    if (part.place <= 1 && table.get(part.name) == nullptr) table.insert(toml::key(part.name), toml::table());
    toml::node* node = table.get(part.name);
    const std::size_t last = node == nullptr ? 0 : node->is_array() ? node->as_array()->size() : 1;
    if (node != nullptr && node->is_table() && part.place <= 1) return node->as_table();
    if (node != nullptr && node->is_array()) {
        if (part.place == 0 && last > 1)
            return bad_override(words, fmt::format("there are {} of [[{}]]", last, part.name),
                                fmt::format("{0}[1] to {0}[{1}]", part.name, last));
        const std::size_t place = std::max<std::size_t>(part.place, 1);
        if (place <= last && node->as_array()->get(place - 1)->is_table())
            return node->as_array()->get_as<toml::table>(place - 1);
    } else if (node != nullptr && !node->is_table()) {
        return bad_override(words, fmt::format("{} is no section", part.name), "SECTION.KEY=VALUE");
    }
    return bad_override(words, fmt::format("there is no {}[{}]", part.name, part.place),
                        last == 0 ? "a scene that has one" : fmt::format("{0}[1] to {0}[{1}]", part.name, last));
}

// What is no value of TOML is a text. A key that is replaced has a line, a new one none.
void insert_value(toml::table& table, const std::string& key, const std::string& value) {
    table.erase(key);
    if (value.find_first_of("\r\n#") == std::string::npos)
        if (auto parsed = toml_of("value = " + value, "--set"); parsed && parsed->size() == 1)
            if (toml::node* node = parsed->get("value"); node != nullptr) {
                node->visit([&](auto& found) { table.insert(toml::key(key), std::move(found)); });
                return;
            }
    table.insert(toml::key(key), value);
}

// As messages call the key: ball[1].radius is ball.radius.
std::string as_said(std::string key) {
    if (const std::size_t first = key.find("[1]"); first != std::string::npos) key.erase(first, 3);
    return key;
}

}  // namespace

Result<SceneOverride> parse_override(const std::string& words) {
    const std::size_t equals = words.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == words.size())
        return bad_override(words, "not a key and its value", "KEY=VALUE, as in camera.theta=30");
    return SceneOverride{words.substr(0, equals), words.substr(equals + 1)};
}

Result<SceneOverrides> parse_overrides(const std::vector<std::string>& words) {
    SceneOverrides overrides;
    for (const std::string& word : words) {
        TRY(one, parse_override(word));
        overrides.push_back(std::move(*one));
    }
    return overrides;
}

Status override_values(toml::table& root, const SceneOverrides& overrides) {
    for (const SceneOverride& one : overrides) {
        const std::vector<std::string> parts = split(one.key, '.');
        toml::table* table = &root;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::optional<Part> part = part_of(parts[i]);
            const bool last = i + 1 == parts.size();
            if (!part || part->name.empty() || parts.size() > kMostParts || (last && part->place > 0))
                return bad_override(one.words(), "no key", "SECTION.KEY=VALUE, of several ball[2].radius=3");
            if (last) {
                insert_value(*table, part->name, one.value);
            } else {
                TRY(section, section_in(*table, *part, one.words()));
                table = *section;
            }
        }
    }
    return Done{};
}

Error where_overridden(Error error, const SceneOverrides& overrides) {
    if (error.line > 0) return error;
    const auto found =
        std::ranges::find(overrides, error.key, [](const SceneOverride& one) { return as_said(one.key); });
    if (found == overrides.end()) return error;
    error.file = without_controls("--set " + found->words()), error.key.clear();
    return error;
}

}  // namespace nullscope
