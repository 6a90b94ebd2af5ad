#include "studio/history.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "scenefile/scene_text.h"
#include "studio/comparison.h"

namespace nullscope::viewer {
namespace {

bool is_size(const SceneLine& line) { return line.name == "camera.size"; }

// What flights, drags, falls and clocks change.
bool is_of_place(const std::string& name) {
    return (name.starts_with("camera.") && name != "camera.exposure") || name.starts_with("zoom.") || name == "time";
}

// "ball[2].radius": "ball[2]".
std::string section_of(const std::string& name) { return name.substr(0, name.find('.')); }

// Of ViewState, as far as its changes are named.
struct Compared {
    const Scene& scene;
    const EffectSet& off;
    const MethodWish& method;
};

// Sections that come or go, the keys whose values differ, and switches; of many the first ones. Empty: all is the same.
std::string changes_between(const Compared& a, const Compared& b) {
    constexpr std::size_t kMostNamed = 3;
    std::map<std::string, std::string> before, after;
    for (const SceneLine& line : scene_lines(a.scene))
        if (!is_size(line)) before[line.name] = line.value;
    for (const SceneLine& line : scene_lines(b.scene))
        if (!is_size(line)) after[line.name] = line.value;
    std::vector<std::string> names;
    const auto has_section = [](const auto& lines, const std::string& section) {
        const auto found = lines.lower_bound(section);
        return found != lines.end() && section_of(found->first) == section;
    };
    const auto name = [&](const std::string& key, const auto& other, const char* verb) {
        const std::string section = section_of(key);
        std::string words = key.find('.') != std::string::npos && !has_section(other, section) ? section + verb : key;
        if (std::ranges::find(names, words) == names.end()) names.push_back(std::move(words));
    };
    for (const auto& [key, value] : after) {
        const auto found = before.find(key);
        if (found == before.end() || found->second != value) name(key, before, " added");
    }
    for (const auto& [key, value] : before)
        if (!after.contains(key)) name(key, after, " removed");
    for (const EffectRow* row : effect_rows())
        if (a.off.contains(row->effect) != b.off.contains(row->effect))
            names.push_back(
                fmt::format("effect {} {}", row->key, b.off.contains(row->effect) ? "switched off" : "switched on"));
    if (a.method != b.method) names.emplace_back("method");
    if (names.size() > 1 && std::ranges::all_of(names, is_of_place)) return "camera";
    if (names.size() <= kMostNamed) return fmt::format("{}", fmt::join(names, ", "));
    return fmt::format("{} and {} more", fmt::join(names.begin(), names.begin() + kMostNamed, ", "),
                       names.size() - kMostNamed);
}

}  // namespace

History::Words History::words_of(const Scene& scene) {
    Words words;
    for (const SceneLine& line : scene_lines(scene))
        if (!is_size(line))
            (is_of_place(line.name) ? words.place : words.rest) += fmt::format("{} = {}\n", line.name, line.value);
    return words;
}

// The camera alone, or nothing at all.
bool History::moved_since(const Step& step, const ViewState& view, const Words& words) {
    return step.words.rest == words.rest && step.source == view.source && step.off == view.off &&
           step.method == view.method;
}

void History::rest(const ViewState& view) {
    Words words = words_of(view.scene);
    bool moved = false;
    if (!steps_.empty()) {
        Step& last = steps_[at_];
        moved = moved_since(last, view, words) && !sides_swapped(last.sides, view.sides);
        if (moved && last.words.place == words.place) {
            last.hidden = view.hidden, last.jumps = view.jumps, last.sides = view.sides;
            return;
        }
        moved = moved && last.jumps == view.jumps;
        steps_.resize(at_ + 1);
        if (moved && steps_.back().moved) steps_.pop_back();
    }
    steps_.push_back({view.source, view.loaded, view.scene, view.off, view.method, view.hidden, view.sides,
                      std::move(words), view.jumps, moved});
    if (steps_.size() > kMostSteps) steps_.erase(steps_.begin());
    at_ = steps_.size() - 1;
}

void History::saved(const std::string& from, const std::string& file) {
    std::size_t first = at_, end = at_;
    while (first > 0 && steps_[first - 1].source == from) --first;
    while (end < steps_.size() && steps_[end].source == from) ++end;
    for (std::size_t i = first; i < end; ++i) steps_[i].source = file;
}

bool History::undo(ViewState& view, std::string& what) {
    rest(view);  // what has not come to rest yet
    return at_ > 0 && go_to(at_ - 1, view, what);
}

bool History::redo(ViewState& view, std::string& what) {
    if (at_ + 1 >= steps_.size()) return false;
    const Words words = words_of(view.scene);
    return moved_since(steps_[at_], view, words) && steps_[at_].words.place == words.place &&
           go_to(at_ + 1, view, what);
}

bool History::go_to(std::size_t step, ViewState& view, std::string& what) {
    const Step& to = steps_[step];
    const Compared there{to.scene, to.off, to.method}, here{view.scene, view.off, view.method};
    const bool swapped = view.side_b != nullptr && sides_swapped(to.sides, view.sides);
    what = to.source != view.source ? "another scene"
           : swapped                ? ""
           : step < at_             ? changes_between(there, here)
                                    : changes_between(here, there);
    if (what.empty()) what = "sides swapped";  // also of a comparison that has ended
    if (swapped) swap_sides(view);
    at_ = step;
    const CameraSpec now = view.scene.camera;
    view.source = to.source, view.loaded = to.loaded, view.scene = to.scene;
    view.off = to.off, view.method = to.method, view.hidden = to.hidden, view.jumps = to.jumps;
    view.scene.camera.width = now.width, view.scene.camera.height = now.height;
    if (view.scene.disc) view.hidden_disc = *view.scene.disc;
    view.fall.stop();
    view.clock_runs = false;
    view.error.clear();
    return true;
}

}  // namespace nullscope::viewer
