#include "scenefile/scene_edit.h"

#include <algorithm>
#include <map>
#include <utility>

#include "plan/body_kind.h"
#include "scenefile/scene_check.h"
#include "scenefile/scene_file.h"
#include "scenefile/scene_keys.h"
#include "scenefile/scene_writer.h"

namespace nullscope {
namespace {

const BodyKind* body_kind(std::string_view section) {
    const auto kinds = body_kinds();
    const auto found = std::ranges::find(kinds, section, [](const BodyKind* kind) { return kind->key; });
    return found == kinds.end() ? nullptr : *found;
}

// Where bodies of this kind are in scene.bodies.
std::vector<std::size_t> places_of(const Scene& scene, const BodyKind& kind) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        if (&kind_of(scene.bodies[i]) == &kind) places.push_back(i);
    return places;
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
    for_each_section(scene, [&](std::string_view section, const std::string& label, const Scene&) {
        sections.push_back({std::string(section), seen[std::string(section)]++, label});
    });
    return sections;
}

void exchange_with_last(Scene& scene, const SectionRef& at) {
    if (at.section == "spot" && at.index < scene.spots.size()) std::swap(scene.spots[at.index], scene.spots.back());
    if (const BodyKind* kind = body_kind(at.section)) {
        const auto places = places_of(scene, *kind);
        if (at.index < places.size()) std::swap(scene.bodies[places[at.index]], scene.bodies[places.back()]);
    }
}

Scene section_holder(const Scene& scene, const SectionRef& at) {
    Scene holder = scene;
    exchange_with_last(holder, at);
    return holder;
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
    std::vector<std::string> sections = {"disc", "spot", "medium", "split", "path", "zoom"};
    for (const BodyKind* kind : body_kinds()) sections.emplace_back(kind->key);
    return sections;
}

bool is_of_several(std::string_view section) { return section == "spot" || body_kind(section) != nullptr; }

Result<Scene> with_section(const Scene& scene, std::string_view section) {
    Scene edited = scene;
    if (section == "disc" && !edited.disc) edited.disc.emplace();
    if (section == "medium" && !edited.medium) edited.medium.emplace();
    if (section == "split" && !edited.split) edited.split = SpacetimeSpec{"minkowski", {}};
    if (section == "path" && !edited.path) edited.path.emplace();
    if (section == "zoom" && !edited.camera.zoom) edited.camera.zoom.emplace();
    if (section == "spot") edited.spots.emplace_back();
    if (const BodyKind* kind = body_kind(section)) edited.bodies.push_back(kind->make());
    return checked(edited);
}

Result<Scene> with_copy(const Scene& scene, const SectionRef& at) {
    Scene edited = scene;
    if (at.section == "spot" && at.index < edited.spots.size())
        edited.spots.insert(edited.spots.begin() + static_cast<std::ptrdiff_t>(at.index) + 1, scene.spots[at.index]);
    if (const BodyKind* kind = body_kind(at.section))
        if (const auto places = places_of(edited, *kind); at.index < places.size())
            edited.bodies.insert(edited.bodies.begin() + static_cast<std::ptrdiff_t>(places[at.index]) + 1,
                                 scene.bodies[places[at.index]]);
    return checked(edited);
}

Result<Scene> without_section(const Scene& scene, const SectionRef& at) {
    Scene edited = scene;
    if (at.section == "disc") edited.disc.reset();
    if (at.section == "medium") edited.medium.reset();
    if (at.section == "split") edited.split.reset();
    if (at.section == "path") edited.path.reset();
    if (at.section == "zoom") edited.camera.zoom.reset();
    if (at.section == "spot" && at.index < edited.spots.size())
        edited.spots.erase(edited.spots.begin() + static_cast<std::ptrdiff_t>(at.index));
    if (const BodyKind* kind = body_kind(at.section))
        if (const auto places = places_of(edited, *kind); at.index < places.size())
            edited.bodies.erase(edited.bodies.begin() + static_cast<std::ptrdiff_t>(places[at.index]));
    return checked(edited);
}

}  // namespace nullscope
