#include "scenefile/path_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "observer/path.h"
#include "scenefile/scene_check.h"
#include "scenefile/sections.h"
#include "spacetime/registry.h"

namespace nullscope {
namespace {

constexpr const char* kNumbersOfSections = "SECTION.KEY of a number outside of [camera], [zoom] and [path]";

const SectionList* list_of(const PathValue& value) { return find_section(value.section)->list; }

// Its section last of its kind while f looks: a row's member is of the last.
template <class F>
void with_last(Scene& scene, const PathValue& value, const F& f) {
    const SectionList* list = list_of(value);
    if (list == nullptr) return f(scene);
    const std::size_t at = places_of(scene, *find_section(value.section))[value.place], last = list->size(scene) - 1;
    if (at != last) list->exchange(scene, at, last);
    f(scene);
    if (at != last) list->exchange(scene, at, last);
}

std::optional<SceneKey> number_row(const Scene& scene, const Section& section, const std::string& name,
                                   bool& of_metric) {
    for (const SceneKey& key : keys_of(section.name))
        if (key.key == name && key.type == KeyType::kNumber && key.member.readable()) return key;
    if (!section.spacetime) return {};
    const MetricEntry* metric = find_metric(section.spacetime.of(scene).metric);
    for (const MetricParameter& parameter : metric->parameters)
        if (parameter.name == name) {
            of_metric = true;
            return SceneKey{.section = section.name,
                            .key = parameter.name,
                            .type = KeyType::kNumber,
                            .range = {parameter.low, parameter.high}};
        }
    return {};
}

}  // namespace

Result<PathValue> path_value(const Scene& scene, const std::string& name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos) return bad_input("no number of a section", kNumbersOfSections);
    std::string head = name.substr(0, dot);
    PathValue value{{}, head, 0};
    if (const std::size_t open = head.find('['); open != std::string::npos) {
        const auto place =
            head.back() == ']' ? parse_number(head.substr(open + 1, head.size() - open - 2)) : std::nullopt;
        if (!place || !(*place >= 1 && *place <= 1e6)) return bad_input("no section", kNumbersOfSections);
        value.section = head.substr(0, open), value.place = static_cast<std::size_t>(*place) - 1;
    }
    const Section* section = find_section(value.section);
    if (section == nullptr || value.section == "camera" || value.section == "zoom" || value.section == "path")
        return bad_input("no number that a path sets", kNumbersOfSections);
    const std::size_t there = count_of(scene, *section);
    if (value.place >= there && (section->list != nullptr || section->there != nullptr))
        return bad_input(fmt::format("the scene has {} of [{}]", there, value.section), "a section that is there");
    const auto row = number_row(scene, *section, name.substr(dot + 1), value.of_metric);
    if (!row) return bad_input("no number that a path sets", kNumbersOfSections);
    value.key = *row;
    return value;
}

std::optional<double> number_of(const Scene& scene, const PathValue& value) {
    if (value.of_metric) {
        const SpacetimeSpec& spec = find_section(value.section)->spacetime.of(scene);
        const auto given = spec.parameters.find(std::string(value.key.key));
        if (given != spec.parameters.end()) return given->second;
        for (const MetricParameter& parameter : find_metric(spec.metric)->parameters)
            if (parameter.name == value.key.key) return parameter.fallback;
        return {};
    }
    const SectionList* list = list_of(value);
    const KeyValue found =
        list == nullptr
            ? value.key.member.get(scene)
            : value.key.member.get(list->alone(scene, places_of(scene, *find_section(value.section))[value.place]));
    return found.there ? std::optional(found.number) : std::nullopt;
}

void set_number(Scene& scene, const PathValue& value, double number) {
    if (value.of_metric) {
        find_section(value.section)->spacetime.of(scene).parameters[std::string(value.key.key)] = number;
        return;
    }
    KeyValue wanted;
    wanted.number = number;
    with_last(scene, value, [&](Scene& last) { value.key.member.set(last, wanted); });
}

void set_path_values(Scene& scene, const std::vector<double>& values) {
    if (!scene.path) return;
    const std::vector<std::string> names = scene.path->keyed;
    for (std::size_t i = 0; i < std::min(names.size(), values.size()); ++i)
        if (const auto value = path_value(scene, names[i])) set_number(scene, *value, values[i]);
}

std::vector<double> path_values_of(const Scene& scene) {
    std::vector<double> values;
    for (const std::string& name : scene.path ? scene.path->keyed : std::vector<std::string>()) {
        const auto value = path_value(scene, name);
        values.push_back(value ? number_of(scene, *value).value_or(0.0) : 0.0);
    }
    return values;
}

std::vector<SceneFault> closed_faults(const PathSpec& path) {
    std::vector<SceneFault> faults;
    if (!path.closed || path.kind != PathKind::kKeys || path.keys.empty()) return faults;
    const double span = path.keys.back().frame - path.keys.front().frame;
    if (path.easing != PathEasing::kNone)
        faults.push_back({"path.easing", "a closed path neither begins nor ends", "none, or closed = \"off\""});
    if (!(span < path.frames))
        faults.push_back({"path.frames", "the first key comes again before the last", fmt::format("above {:g}", span)});
    return faults;
}

int frames_of_keys(const PathSpec& path) {
    const double last = path.keys.back().frame, before = (path.keys.end() - 2)->frame;
    return std::max(2, static_cast<int>(last + (path.closed ? last - before : 1.0)));
}

std::optional<PathFault> path_fault(const Scene& scene) {
    constexpr int kMostFrames = 1000;
    if (!scene.path || scene.path->keyed.empty()) return {};
    const auto path = CameraPath::make(scene);
    if (!path) return {};
    const int count = std::min(path->frames(), kMostFrames);
    const GivenKeys none = [](const std::string&) { return false; };
    for (int i = 0; i < count; ++i) {
        const double frame = std::round(i * (path->frames() - 1.0) / (count - 1.0));
        Scene now = scene;
        set_path_values(now, path->values(frame));
        now.camera = path->at(frame);
        now.path.reset();
        std::vector<SceneFault> faults = check_camera(now, none);
        if (faults.empty()) faults = check_parts(now, none);
        if (!faults.empty()) return PathFault{frame, faults.front().key, faults.front().what, faults.front().allowed};
    }
    return {};
}

}  // namespace nullscope
