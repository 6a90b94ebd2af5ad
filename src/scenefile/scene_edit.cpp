#include "scenefile/scene_edit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "base/text.h"
#include "scene/bodies.h"
#include "scenefile/scene_file.h"
#include "scenefile/scene_writer.h"
#include "scenefile/sections.h"

namespace nullscope {
namespace {

// Where this section is in the list of those that there may be several of.
std::optional<std::size_t> place_in_list(const Scene& scene, const SectionRef& at) {
    const Section* section = find_section(at.section);
    const auto places = section != nullptr ? places_of(scene, *section) : std::vector<std::size_t>();
    return at.index < places.size() ? std::optional(places[at.index]) : std::nullopt;
}

// The error is one of the scene, not of the text that is read again.
Error without_place(Error error) {
    error.file.clear(), error.line = 0;
    return error;
}

Result<Scene> checked(const Scene& scene) {
    auto again = parse_scene(scene_file_text(scene, {}), "edited", {});
    return again ? again : without_place(again.error());
}

}  // namespace

std::vector<SectionRef> scene_sections(const Scene& scene) {
    std::vector<SectionRef> sections;
    std::map<std::string, std::size_t, std::less<>> seen;
    for_each_section(scene, [&](const Section& section, const std::string& label, const Scene&) {
        sections.push_back({std::string(section.name), seen[std::string(section.name)]++, label});
    });
    return sections;
}

std::string last_label(const Scene& scene, std::string_view section) {
    return section_label(section, count_of(scene, *find_section(section)) - 1);
}

void exchange_with_last(Scene& scene, const SectionRef& at) {
    const auto place = place_in_list(scene, at);
    if (!place) return;
    const Section& section = *find_section(at.section);
    section.list->exchange(scene, *place, places_of(scene, section).back());
}

Scene section_holder(const Scene& scene, const SectionRef& at) {
    Scene holder = scene;
    exchange_with_last(holder, at);
    return holder;
}

std::string typed_numbers(const std::vector<double>& numbers) {
    return fmt::format("{:.12g}", fmt::join(numbers, ", "));
}

bool take_typed_numbers(const std::string& text, std::vector<double>& numbers) {
    std::vector<double> typed;
    for (const std::string& word : split(text, ',')) typed.push_back(parse_number(word).value_or(std::nan("")));
    return std::exchange(numbers, typed) != typed;
}

Result<Scene> with_value(const Scene& scene, const SectionRef& at, const SceneKey& key, const KeyValue& value) {
    Scene edited = section_holder(scene, at);
    key.member.set(edited, value);
    exchange_with_last(edited, at);
    return checked(edited);
}

Result<Scene> savable(const Scene& scene) {
    auto good = checked(scene);
    if (good || scene.picture.scale_bar == ScaleBar::kOff) return good;
    Scene without = scene;
    without.picture.scale_bar = ScaleBar::kOff;
    auto second = checked(without);
    return second ? second : good;
}

Result<CameraSpec> camera_of_view(const std::string& line, const Scene& scene) {
    if (!line.starts_with("camera")) return bad_input("no view", "camera = { r = 15, theta = 80, ... }");
    Scene place;
    place.spacetime = scene.spacetime;
    place.name = "view";
    auto read = parse_scene(line.substr(0, line.find('\n')) + '\n' + scene_file_text(place, {}), "view", {});
    if (!read) return without_place(read.error());
    read->camera.width = scene.camera.width, read->camera.height = scene.camera.height;
    return read->camera;
}

std::vector<std::string> optional_sections() {
    std::vector<std::string> names;
    for (const Section& section : sections())
        if (section.optional()) names.emplace_back(section.name);
    return names;
}

bool is_of_several(std::string_view name) {
    const Section* section = find_section(name);
    return section != nullptr && section->list != nullptr;
}

bool can_be_added(const Scene& scene, std::string_view name) {
    const Section* section = find_section(name);
    return section != nullptr && section->optional() && (section->list != nullptr || count_of(scene, *section) == 0);
}

Result<Scene> with_section(const Scene& scene, std::string_view name) {
    Scene edited = scene;
    if (can_be_added(scene, name)) {
        const Section& section = *find_section(name);
        section.add(edited);
        if (section.propose != nullptr) section.propose(edited);
    }
    return checked(edited);
}

Result<Scene> with_copy(const Scene& scene, const SectionRef& at) {
    Scene edited = scene;
    if (const auto place = place_in_list(scene, at)) find_section(at.section)->list->repeat(edited, *place);
    return checked(edited);
}

Result<Scene> without_section(const Scene& scene, const SectionRef& at) {
    Scene edited = scene;
    const Section* section = find_section(at.section);
    if (section != nullptr && section->remove != nullptr) section->remove(edited);
    if (const auto place = place_in_list(scene, at)) section->list->erase(edited, *place);
    return checked(edited);
}

}  // namespace nullscope
