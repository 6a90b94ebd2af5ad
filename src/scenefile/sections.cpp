#include "scenefile/sections.h"

#include <algorithm>
#include <map>

#include "plan/body_kind.h"
#include "scene/bodies.h"
#include "scenefile/scene_keys.h"

namespace nullscope {
namespace {

template <auto Member>
constexpr SectionList list_of(std::size_t most, std::string_view words) {
    return {most,
            words,
            [](const Scene& s) { return (s.*Member).size(); },
            [](Scene& s, std::size_t i) { (s.*Member).erase((s.*Member).begin() + static_cast<std::ptrdiff_t>(i)); },
            [](Scene& s, std::size_t i) {
                const auto one = (s.*Member)[i];
                (s.*Member).insert((s.*Member).begin() + static_cast<std::ptrdiff_t>(i) + 1, one);
            },
            [](Scene& s, std::size_t i, std::size_t k) { std::swap((s.*Member)[i], (s.*Member)[k]); },
            [](const Scene& s, std::size_t i) {
                Scene alone;
                (alone.*Member) = {(s.*Member)[i]};
                return alone;
            }};
}
constexpr SectionList kSpots = list_of<&Scene::spots>(kMostSpots, "[[spot]]");
constexpr SectionList kCaps = list_of<&Scene::caps>(kMostCaps, "[[cap]]");
constexpr SectionList kBodies = list_of<&Scene::bodies>(kMostBodies, "bodies");

// One that a scene has or has not. part: [](auto& s) { return &s.disc; }, an optional.
template <class Part>
Section once(std::string_view name, std::string_view help, Part) {
    return {.name = name,
            .help = help,
            .add = [](Scene& s) { Part{}(s)->emplace(); },
            .there = [](const Scene& s) { return Part{}(s)->has_value(); },
            .remove = [](Scene& s) { Part{}(s)->reset(); }};
}

Section spacetime_row() {
    Section row{.name = "spacetime", .first = "metric"};
    row.spacetime = [](auto& s) { return &s.spacetime; };
    return row;
}

Section zoom_row() {
    Section row = once("zoom", "A magnification towards the photon ring.", [](auto& s) { return &s.camera.zoom; });
    row.within = "camera";
    return row;
}

Section split_row() {
    Section row =
        once("split", "The right half of the picture in another spacetime.", [](auto& s) { return &s.split; });
    row.propose = [](Scene& s) { s.split->metric = "minkowski"; };
    row.spacetime = [](auto& s) { return &*s.split; };
    row.first = "metric";
    return row;
}

Section disc_row() {
    return once("disc", "A flat disc about the hole.", [](auto& s) { return &s.disc; });
}

Section medium_row() {
    return once("medium", "Matter that emits and absorbs light along rays.", [](auto& s) { return &s.medium; });
}

bool path_has_keys(const Scene& s) { return s.path->kind == PathKind::kKeys; }

constexpr SceneKey kClosed[] = {on_off_key(
    "path", "closed", "off",
    "For kind = \"keys\": after path.frames frames the path is where it began, and joins smoothly.",
    [](auto& s) { return &s.path->closed; }, path_has_keys, "kind = \"keys\"")};

Section path_row() {
    Section row = once("path", "Where the camera goes, frame by frame.", [](auto& s) { return &s.path; });
    row.inner = "key", row.keys = kClosed;
    return row;
}

// One of several of a list of their own.
template <auto member>
Section several(std::string_view name, std::string_view help, const SectionList& list) {
    return {.name = name,
            .help = help,
            .add = [](Scene& s) { (s.*member).emplace_back(); },
            .list = &list,
            .is = [](const Scene&, std::size_t) { return true; }};
}

Section body_row(const BodyKind& kind) {
    return {.name = kind.key,
            .help = kind.effect.help,
            .add = [&kind](Scene& s) { s.bodies.push_back(kind.make()); },
            .list = &kBodies,
            .is = [&kind](const Scene& s, std::size_t place) { return &kind_of(s.bodies[place]) == &kind; }};
}

std::vector<Section> all_rows() {
    std::vector<Section> rows = {{.name = ""}, spacetime_row(), {.name = "camera", .first = "projection"}};
    for (const char* name : {"sky", "far_sky", "light", "picture", "object"}) rows.push_back({.name = name});
    rows.push_back(zoom_row());
    rows.push_back(split_row());
    rows.push_back(disc_row());
    rows.push_back(medium_row());
    rows.push_back(path_row());
    rows.push_back(several<&Scene::spots>("spot", "A hot spot that orbits in the disc.", kSpots));
    rows.push_back(several<&Scene::caps>("cap", "A hot cap on a sphere with a temperature.", kCaps));
    for (const BodyKind* kind : body_kinds()) rows.push_back(body_row(*kind));
    return rows;
}

using SectionVisit = std::function<void(const Section&, const std::string& label, const Scene& holder)>;

void visit_list(const Scene& scene, const SectionList& list, const SectionVisit& f) {
    std::map<std::string_view, std::size_t> seen;
    for (std::size_t place = 0; place < list.size(scene); ++place)
        for (const Section& section : sections())
            if (section.list == &list && section.is(scene, place))
                f(section, section_label(section.name, seen[section.name]++), list.alone(scene, place));
}

}  // namespace

std::span<const Section> sections() {
    static const std::vector<Section> rows = all_rows();
    return rows;
}

const Section* find_section(std::string_view name) {
    const auto found = std::ranges::find(sections(), name, &Section::name);
    return found != sections().end() ? &*found : nullptr;
}

std::span<const SceneKey> keys_of(std::string_view section) {
    static const auto groups = [] {
        std::map<std::string_view, std::vector<SceneKey>> found;
        for (const SceneKey& key : scene_keys()) found[key.section].push_back(key);
        return found;
    }();
    const auto group = groups.find(section);
    return group != groups.end() ? std::span<const SceneKey>(group->second) : std::span<const SceneKey>();
}

std::vector<std::size_t> places_of(const Scene& scene, const Section& section) {
    std::vector<std::size_t> places;
    for (std::size_t place = 0; section.list != nullptr && place < section.list->size(scene); ++place)
        if (section.is(scene, place)) places.push_back(place);
    return places;
}

std::size_t count_of(const Scene& scene, const Section& section) {
    if (section.list != nullptr) return places_of(scene, section).size();
    return section.there == nullptr || section.there(scene) ? 1 : 0;
}

void for_each_section(const Scene& scene, const SectionVisit& f) {
    std::vector<const SectionList*> lists;
    for (const Section& section : sections()) {
        if (section.list == nullptr && count_of(scene, section) > 0) f(section, std::string(section.name), scene);
        if (section.list != nullptr && std::ranges::find(lists, section.list) == lists.end())
            lists.push_back(section.list);
    }
    for (const SectionList* list : lists) visit_list(scene, *list, f);
}

}  // namespace nullscope
