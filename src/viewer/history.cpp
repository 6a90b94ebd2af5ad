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

// Of two scenes: the keys whose values differ, or that only one of them has; of many the first ones.
std::string changed_keys(const Scene& a, const Scene& b) {
    constexpr std::size_t kMostNamed = 3;
    std::map<std::string, std::string> before;
    std::vector<std::string> names;
    for (const SceneLine& line : scene_lines(a))
        if (!is_size(line)) before[line.name] = line.value;
    for (const SceneLine& line : scene_lines(b)) {
        if (is_size(line)) continue;
        const auto found = before.find(line.name);
        if (found == before.end() || found->second != line.value) names.push_back(line.name);
        if (found != before.end()) before.erase(found);
    }
    for (const auto& [name, value] : before) names.push_back(name);
    if (names.size() <= kMostNamed) return fmt::format("{}", fmt::join(names, ", "));
    return fmt::format("{} and {} more keys", fmt::join(names.begin(), names.begin() + kMostNamed, ", "),
                       names.size() - kMostNamed);
}

}  // namespace

void History::rest(const ViewState& view) {
    std::string text = text_of(view.scene);
    if (!steps_.empty() && steps_[at_].text == text && steps_[at_].source == view.source) return;
    if (!steps_.empty()) steps_.resize(at_ + 1);
    steps_.push_back({view.source, view.loaded, view.scene, std::move(text)});
    if (steps_.size() > kMostSteps) steps_.erase(steps_.begin());
    at_ = steps_.size() - 1;
}

bool History::undo(ViewState& view, std::string& what) {
    rest(view);  // what has not come to rest yet
    return at_ > 0 && go_to(at_ - 1, view, what);
}

bool History::redo(ViewState& view, std::string& what) {
    return at_ + 1 < steps_.size() && steps_[at_].text == text_of(view.scene) && go_to(at_ + 1, view, what);
}

bool History::go_to(std::size_t step, ViewState& view, std::string& what) {
    const Step& to = steps_[step];
    what = to.source != view.source ? "another scene" : changed_keys(view.scene, to.scene);
    at_ = step;
    const CameraSpec now = view.scene.camera;
    view.source = to.source, view.loaded = to.loaded, view.scene = to.scene;
    view.scene.camera.width = now.width, view.scene.camera.height = now.height;
    if (view.scene.disc) view.hidden_disc = *view.scene.disc;
    view.fall.stop();
    view.clock_runs = false;
    view.error.clear();
    return true;
}

}  // namespace nullscope::viewer
