#include "scenefile/scene_override.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

Error said_of(const SceneOverride& one, Error error) {
    error.file = "--set " + one.words(), error.line = 0;
    return without_controls(std::move(error));
}

// The last words of a key are the ones that hold. nullptr: there are none.
template <class Is>
const SceneOverride* last_of(const SceneOverrides& overrides, const Is& is) {
    const auto found = std::find_if(overrides.rbegin(), overrides.rend(), is);
    return found == overrides.rend() ? nullptr : &*found;
}

// Without the key, the section, or that one of several.
Status leave_out(toml::table& table, const Part& part, const std::string& words) {
    toml::node* node = table.get(part.name);
    toml::array* list = node != nullptr && part.place > 0 ? node->as_array() : nullptr;
    if (list != nullptr && part.place <= list->size()) {
        list->erase(list->begin() + static_cast<std::ptrdiff_t>(part.place - 1));
        return Done{};
    }
    if (node != nullptr && part.place == 0) {
        table.erase(part.name);
        return Done{};
    }
    std::vector<std::string> there;
    for (const auto& [name, value] : table) there.emplace_back(name.str());
    return bad_override(words, "the scene has no such key that could be left out",
                        there.empty() ? "KEY=VALUE" : fmt::format("{}", fmt::join(there, ", ")));
}

}  // namespace

Result<SceneOverride> parse_override(const std::string& words) {
    const std::size_t equals = words.find('=');
    if (equals == std::string::npos || equals == 0)
        return bad_override(words, "not a key and its value",
                            "KEY=VALUE, as in camera.theta=30, or KEY= to leave it out");
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
            if (!part || part->name.empty() || parts.size() > kMostParts ||
                (last && part->place > 0 && !one.value.empty()))
                return bad_override(one.words(), "no key", "SECTION.KEY=VALUE, of several ball[2].radius=3");
            if (last && one.value.empty()) {
                TRY(left_out, leave_out(*table, *part, one.words()));
            } else if (last) {
                insert_value(*table, part->name, one.value);
            } else {
                TRY(section, section_in(*table, *part, one.words()));
                table = *section;
            }
        }
    }
    return Done{};
}

std::optional<Error> error_of_override(Error error, const SceneOverrides& overrides) {
    const SceneOverride* found =
        last_of(overrides, [&](const SceneOverride& one) { return as_said(one.key) == error.key; });
    if (found == nullptr) return std::nullopt;
    error.key.clear();
    return said_of(*found, std::move(error));
}

std::optional<Error> error_of_section(const Error& error, const SceneOverrides& overrides) {
    const auto section_of = [](std::string_view key) { return key.substr(0, key.find_first_of(".[")); };
    const SceneOverride* found =
        last_of(overrides, [&](const SceneOverride& one) { return section_of(one.key) == section_of(error.key); });
    if (found == nullptr) return std::nullopt;
    return said_of(*found, error);
}

Error where_overridden(Error error, const SceneOverrides& overrides,
                       const std::function<bool(const SceneOverrides&)>& reads) {
    if (auto own = error_of_override(error, overrides); own && error.line == 0) return *own;
    if (overrides.empty() || !reads({})) return error;
    const SceneOverride* cause = nullptr;
    for (std::size_t i = 0; i < overrides.size() && cause == nullptr; ++i) {
        SceneOverrides others = overrides;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        if (reads(others)) cause = &overrides[i];
    }
    SceneOverrides with_less = overrides;
    with_less.push_back({error.key, ""});
    if (reads({with_less.back()}) && reads(with_less))
        error.allowed += fmt::format("; --set {}= leaves it out", error.key);
    return said_of(cause != nullptr ? *cause : overrides.back(), std::move(error));
}

}  // namespace nullscope
