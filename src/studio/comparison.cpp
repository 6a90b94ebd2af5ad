#include "studio/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <memory>
#include <numbers>
#include <set>
#include <utility>

#include "annotate/annotations.h"
#include "scenefile/scene_keys.h"
#include "scenefile/scene_text.h"

namespace nullscope::viewer {
namespace {

using Words = std::pair<std::string, std::string>;

std::map<std::string, std::string> settings_of(const Scene& scene) {
    constexpr std::array kShared = {"camera", "path", "key", "time", "name", "description", "split"};
    std::map<std::string, std::string> settings;
    for (const SceneLine& line : scene_lines(scene))
        if (line.name == "camera.exposure" ||
            std::ranges::none_of(kShared, [&](const char* name) { return line.name.starts_with(name); }))
            settings[line.name] = line.value + line.file.string();
    return settings;
}

std::set<std::string> sections_of(const std::map<std::string, std::string>& settings) {
    std::set<std::string> sections;
    for (const auto& [key, value] : settings) sections.insert(key.substr(0, key.find('.')));
    return sections;
}

// As a label says it: numbers in the unit of scene files.
std::string value_words(const std::string& name, const std::string& value) {
    constexpr std::size_t kLongest = 24;
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    if (value.empty() || *end != '\0') return value.substr(0, kLongest);
    const std::string section = name.substr(0, name.find_first_of(".[")), key = name.substr(name.rfind('.') + 1);
    for (const SceneKey& row : scene_keys()) {
        if (row.section != section || row.key != key) continue;
        if (row.unit == "deg") return fmt::format("{:.5g}\u00b0", number * 180.0 / std::numbers::pi);
        return row.unit.empty() ? fmt::format("{:.5g}", number) : fmt::format("{:.5g} {}", number, row.unit);
    }
    return fmt::format("{:.5g}", number);
}

// Sections that one scene alone has, then keys whose values differ.
Words changed_settings(const Scene& a, const Scene& b) {
    constexpr int kMostNamed = 2;
    const auto of_a = settings_of(a), of_b = settings_of(b);
    const auto in_a = sections_of(of_a), in_b = sections_of(of_b);
    Words words;
    int named = 0;
    const auto add = [&](const std::string& here, const std::string& there) {
        if (++named > kMostNamed) return;
        const char* comma = named > 1 ? ", " : "";
        words.first += comma + here, words.second += comma + there;
    };
    for (const std::string& name : in_a)
        if (!in_b.contains(name)) add("with " + name, "without " + name);
    for (const std::string& name : in_b)
        if (!in_a.contains(name)) add("without " + name, "with " + name);
    for (const auto& [key, value] : of_a) {
        const auto other = of_b.find(key);
        if (other != of_b.end() && other->second != value)
            add(key + ' ' + value_words(key, value), key + ' ' + value_words(key, other->second));
    }
    if (named > kMostNamed) words.first += " ...", words.second += " ...";
    return words;
}

Scene seen_in(const ViewState& view, Scene scene) {
    const double exposure_ev = scene.camera.exposure_ev;
    scene.camera = view.scene.camera, scene.path = view.scene.path, scene.time = view.scene.time;
    scene.camera.exposure_ev = exposure_ev;
    return scene;
}

}  // namespace

void swap_sides(ViewState& view) {
    if (view.side_b == nullptr) return;
    const auto b = std::exchange(view.side_b, std::make_shared<SideB>(SideB{view.scene, view.method, view.off}));
    if (b->scene.bodies != view.scene.bodies) view.hidden.clear();
    view.scene = seen_in(view, b->scene), view.method = b->method, view.off = b->off;
    if (view.scene.disc) view.hidden_disc = *view.scene.disc;
    view.sides ^= 1;
}

Scene drawn_side_b(const ViewState& view) {
    ViewState b;
    b.scene = seen_in(view, view.side_b->scene), b.off = view.side_b->off;
    view.hidden.leave_out_of(b.scene, view.scene);
    b.show_grid = view.show_grid;
    return drawn_scene(b);
}

Words side_words(const PaintJob& a, const PaintJob& b) {
    Halves sides{a.scene, b.scene};
    sides.left.name = sides.right.name = "";
    Scene plain = a.scene;
    plain.split_labels = {};
    const Annotations known = annotations_of(plain, sides);
    Words words{known.left, known.right};
    if (words.first.empty()) words = changed_settings(a.scene, b.scene);
    if (words.first.empty() && a.method != b.method) words = {method_name(a.method), method_name(b.method)};
    const char* colon = words.first.empty() ? "" : ": ";
    return {"A" + (colon + words.first), "B" + (colon + words.second)};
}

}  // namespace nullscope::viewer
