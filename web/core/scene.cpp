// Scenes as text: opened, changed key by key, written, explained.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <sstream>

#include <toml++/toml.h>

#include "base/assets.h"
#include "base/atomic_file.h"
#include "base/text.h"
#include "core/exports.h"
#include "core/session.h"
#include "plan/effects.h"
#include "scenefile/scene_file.h"
#include "scenefile/scene_keys.h"
#include "scenefile/scene_writer.h"
#include "scenefile/sections.h"
#include "scenefile/toml_text.h"
#include "spacetime/registry.h"

namespace nullscope::web {
namespace {

std::filesystem::path folder() { return assets_directory() / "scenes"; }

bool take(Result<Scene> scene) {
    if (!scene) return answer(scene.error());
    session() = {std::move(*scene), {}};
    return answer(std::string());
}

std::string range_json(const KeyRange& range) { return fmt::format("[{:.17g}, {:.17g}]", range.low, range.high); }

std::string words_json(std::string_view words) {
    std::vector<std::string> list;
    for (const std::string& word : split(words, ' '))
        if (!word.empty()) list.push_back(in_json(word));
    return fmt::format("[{}]", fmt::join(list, ", "));
}

// What the key's value is, as a scene file has it; its default where the file says nothing.
std::string value_of(const toml::table& file, const std::string& name, std::string_view fallback) {
    const toml::node_view node = file.at_path(name);
    if (!node) return std::string(fallback);
    if (const auto text = node.value_exact<std::string>()) return *text;
    std::ostringstream out;
    node.visit([&](const auto& value) { out << value; });
    return out.str();
}

// A text at the top of a scene's file, which may show images that the page has not fetched: then it is no scene yet.
std::string own_words(const SceneInfo& scene, std::string_view key, const std::string& else_words) {
    const auto text = read_text(scene.path, kLargestSceneFile);
    if (!text) return else_words;
    const auto file = toml_of(*text, scene.name);
    return file ? (*file)[key].value_or(else_words) : else_words;
}

}  // namespace

Session& session() {
    static Session only;
    return only;
}

// Replaces what is shown; false: the answer says why not, and everything stays.
NULLSCOPE_EXPORT(open_scene)
bool open_scene(const char* text, std::size_t size, const char* label, std::size_t label_size) {
    return take(parse_scene({text, size}, {label, label_size}, folder()));
}
// The same of one line, as scene_as_line() gives it.
NULLSCOPE_EXPORT(open_line) bool open_line(const char* text, std::size_t size) {
    return take(scene_of_line({text, size}));
}

NULLSCOPE_EXPORT(scene_as_text) bool scene_as_text() { return answer(scene_file_text(session().scene, folder())); }
NULLSCOPE_EXPORT(scene_as_line) bool scene_as_line() { return answer(scene_line(session().scene)); }

// One key gets another value, both as a scene file has them ("spacetime.spin", "0.9"). Checked like a file; camera and clock stay.
// An empty value leaves the key out.
NULLSCOPE_EXPORT(set_key)
bool set_key(const char* name, std::size_t name_size, const char* value, std::size_t value_size) {
    const std::string key(name, name_size);
    const std::size_t dot = key.find('.');
    auto file = toml_of(scene_file_text(session().scene, folder()), "scene");
    const auto given = toml_of(value_size > 0 ? fmt::format("x = {}", std::string_view(value, value_size)) : "", key);
    if (!file) return answer(file.error());
    if (!given) return answer(given.error());
    toml::table* section = &*file;
    if (dot != std::string::npos) {
        const std::string title = key.substr(0, dot);
        if (!file->contains(title)) file->insert(title, toml::table());
        section = file->get_as<toml::table>(title);
        if (section == nullptr) return answer(bad_input(key + ": there may be several of them"));
    }
    const std::string own = key.substr(dot == std::string::npos ? 0 : dot + 1);
    if (value_size > 0)
        section->insert_or_assign(own, *given->get("x"));
    else
        section->erase(own);
    std::ostringstream text;
    text << *file;
    auto scene = parse_scene(text.str(), "scene", folder());
    if (!scene) return answer(scene.error());
    session().scene = std::move(*scene);
    session().fall.stop();
    return answer(std::string());
}

// The key table, with what the scene has: [{"name", "type", "unit", "value", "range", "choices", "help", "meant", "optional"}, ...];
// meant: in this scene, which has its section; optional: without a default.
NULLSCOPE_EXPORT(keys) bool keys() {
    const auto file = toml_of(scene_file_text(session().scene, folder()), "scene");
    if (!file) return answer(file.error());
    constexpr const char* kTypes[] = {"number", "velocity", "point", "colour", "size",    "whole",
                                      "choice", "text",     "file",  "metric", "formula", "numbers"};  // by KeyType
    std::vector<std::string> list;
    std::map<std::string_view, Scene, std::less<>> holders;  // by the section, of those that are there
    for_each_section(session().scene, [&](const Section& section, const std::string&, const Scene& holder) {
        holders.emplace(section.name, holder);
    });
    for (const SceneKey& key : scene_keys()) {
        const std::string name = full_name(key);
        const auto holder = holders.find(key.section);
        const bool meant = holder != holders.end() && (key.meant == nullptr || key.meant(holder->second));
        list.push_back(fmt::format(
            R"({{"name": {}, "type": "{}", "unit": {}, "value": {}, "range": {}, "choices": {}, "help": {}, "meant": {}, "optional": {}}})",
            in_json(name), kTypes[static_cast<int>(key.type)], in_json(key.unit),
            in_json(value_of(*file, name, key.fallback)), range_json(key.range),
            words_json(key.type == KeyType::kChoice ? key.choices : ""), in_json(key.help), meant,
            key.fallback.empty()));
    }
    return answer(fmt::format("[{}]", fmt::join(list, ",\n")));
}

// [{"metric", "help", "parameters": [{"name", "value", "range", "help"}, ...]}, ...]
NULLSCOPE_EXPORT(metrics) bool metrics() {
    const SpacetimeSpec& now = session().scene.spacetime;
    std::vector<std::string> list;
    for (const MetricEntry& entry : metric_registry()) {
        std::vector<std::string> parameters;
        for (const MetricParameter& p : entry.parameters) {
            const MetricParameters::Numbers& numbers = now.parameters;
            const auto found = now.metric == entry.key ? numbers.find(std::string(p.name)) : numbers.end();
            parameters.push_back(fmt::format(
                R"({{"name": {}, "value": {:.17g}, "range": [{:.17g}, {:.17g}], "help": {}}})", in_json(p.name),
                found == numbers.end() ? p.fallback : found->second, p.low, p.high, in_json(p.help)));
        }
        list.push_back(fmt::format(R"({{"metric": {}, "help": {}, "formulas": {}, "parameters": [{}]}})",
                                   in_json(entry.key), in_json(entry.help), !entry.formulas.empty(),
                                   fmt::join(parameters, ", ")));
    }
    return answer(fmt::format("[{}]", fmt::join(list, ",\n")));
}

// What the scene calls for: [{"effect", "reason", "cost"}, ...].
NULLSCOPE_EXPORT(plan) bool plan() {
    std::vector<std::string> list;
    for (const EffectReason& effect : required_effects(session().scene)) {
        const EffectRow& row = effect_row(effect.effect);
        list.push_back(fmt::format(R"({{"effect": {}, "reason": {}, "cost": {}}})", in_json(row.key),
                                   in_json(effect.reason), in_json(row.cost)));
    }
    return answer(fmt::format("[{}]", fmt::join(list, ",\n")));
}

// That no scene in memory has this name, and which one may be meant.
NULLSCOPE_EXPORT(no_scene) bool no_scene(const char* name, std::size_t size) {
    std::vector<std::string> names;
    for (const SceneInfo& scene : shipped_scenes()) names.push_back(scene.name);
    const std::string nearest = nearest_word({name, size}, names);
    return answer(fmt::format("{}: no scene of this name ships{}", in_quotes({name, size}),
                              nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest)));
}

// The scenes that the page has put into memory, in the gallery's order: [{"group", "name", "title", "description"}, ...].
NULLSCOPE_EXPORT(gallery) bool gallery() {
    std::vector<std::string> list;
    for (const SceneGroup& group : in_gallery_groups(shipped_scenes()))
        for (const SceneInfo& scene : group.scenes)
            list.push_back(fmt::format(R"({{"group": {}, "name": {}, "title": {}, "description": {}}})",
                                       in_json(group.title), in_json(scene.name),
                                       in_json(own_words(scene, "name", scene.title)),
                                       in_json(own_words(scene, "description", scene.description))));
    return answer(fmt::format("[{}]", fmt::join(list, ",\n")));
}

}  // namespace nullscope::web
