#include "viewer/history.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "scenefile/scene_text.h"

namespace nullscope::viewer {
namespace {

bool is_size(const SceneLine& line) { return line.name == "camera.size"; }

std::string text_of(const Scene& scene) {
    std::string text;
    for (const SceneLine& line : scene_lines(scene))
        if (!is_size(line)) text += fmt::format("{} = {}\n", line.name, line.value);
    return text;
}

// "ball[2].radius": "ball[2]".
std::string section_of(const std::string& name) { return name.substr(0, name.find('.')); }

// Of two scenes: sections that come or go, and the keys whose values differ; of many the first ones.
std::string changes_between(const Scene& a, const Scene& b) {
    constexpr std::size_t kMostNamed = 3;
    std::map<std::string, std::string> before, after;
    for (const SceneLine& line : scene_lines(a))
        if (!is_size(line)) before[line.name] = line.value;
    for (const SceneLine& line : scene_lines(b))
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
    const auto of_camera = [](const std::string& name_of) { return name_of.starts_with("camera."); };
    if (names.size() > 1 && std::ranges::all_of(names, of_camera)) return "camera";
    if (names.size() <= kMostNamed) return fmt::format("{}", fmt::join(names, ", "));
    return fmt::format("{} and {} more", fmt::join(names.begin(), names.begin() + kMostNamed, ", "),
                       names.size() - kMostNamed);
}

}  // namespace

void History::rest(const ViewState& view) {
    std::string text = text_of(view.scene);
    if (!steps_.empty() && steps_[at_].text == text && steps_[at_].source == view.source &&
        steps_[at_].off == view.off) {
        steps_[at_].hidden = view.hidden;
        return;
    }
    if (!steps_.empty()) steps_.resize(at_ + 1);
    steps_.push_back({view.source, view.loaded, view.scene, view.off, view.hidden, std::move(text)});
    if (steps_.size() > kMostSteps) steps_.erase(steps_.begin());
    at_ = steps_.size() - 1;
}

bool History::undo(ViewState& view, std::string& what) {
    rest(view);  // what has not come to rest yet
    return at_ > 0 && go_to(at_ - 1, view, what);
}

bool History::redo(ViewState& view, std::string& what) {
    return at_ + 1 < steps_.size() && steps_[at_].text == text_of(view.scene) && steps_[at_].off == view.off &&
           go_to(at_ + 1, view, what);
}

bool History::go_to(std::size_t step, ViewState& view, std::string& what) {
    const Step& to = steps_[step];
    what = to.source != view.source ? "another scene"
           : step < at_             ? changes_between(to.scene, view.scene)
                                    : changes_between(view.scene, to.scene);
    if (what.empty()) what = "effects that are switched off";
    at_ = step;
    const CameraSpec now = view.scene.camera;
    view.source = to.source, view.loaded = to.loaded, view.scene = to.scene;
    view.off = to.off, view.hidden = to.hidden;
    view.scene.camera.width = now.width, view.scene.camera.height = now.height;
    if (view.scene.disc) view.hidden_disc = *view.scene.disc;
    view.fall.stop();
    view.clock_runs = false;
    view.error.clear();
    return true;
}

}  // namespace nullscope::viewer
