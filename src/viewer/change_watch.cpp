#include "viewer/change_watch.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "annotate/ticks.h"
#include "gradient/picture_motion.h"
#include "platform/usage.h"

namespace nullscope::viewer {
namespace {

constexpr double kOneDegree = std::numbers::pi / 180.0;
constexpr double kPartOfRadius = 0.01;  // of camera.r, its step

ChangeKey key_of(const std::string& name, const Scene& scene) {
    if (name == "spin" || name == "charge") return {name, 0.01, "+ 0.01"};
    if (name == "camera.r") return {name, kPartOfRadius * scene.camera.r, "+ 1 %"};
    if (name == "disc.precession") return {name, 0.001, "+ 0.001 rad per r_s/c"};
    return {name, kOneDegree, "+ 1\u00b0"};
}

}  // namespace

std::vector<ChangeKey> change_keys(const Scene& scene) {
    std::vector<ChangeKey> keys;
    for (const std::string_view name : parameter_names(scene)) {
        constexpr std::string_view kSpacetime = "spacetime.";
        keys.push_back(
            key_of(std::string(name.starts_with(kSpacetime) ? name.substr(kSpacetime.size()) : name), scene));
    }
    return keys;
}

void ChangeWatch::look(int number, const Scene& scene, const ChangeKey& key, bool rests, std::function<void()> news) {
    if (number == number_ && key.name == key_) return;
    forget();
    if (!rests) return;
    number_ = number, key_ = key.name, works_ = waits_ = true;
    worker_ = std::jthread([this, scene, key, news = std::move(news)](const std::stop_token& stop) {
        platform::give_way();  // frames come first
        find(stop, scene, key);
        const bool whole = !stop.stop_requested();
        works_ = false, news_ = whole;
        if (whole) news();
    });
}

void ChangeWatch::find(const std::stop_token& stop, const Scene& scene, const ChangeKey& key) {
    const auto motion = PictureMotion::make(scene, {key.name});
    if (!motion) {
        error_ = motion.error().message();
        return;
    }
    const int width = scene.camera.width, height = scene.camera.height;
    const TickGrid grid = tick_grid(width, height);
    for (int i = 0; i < grid.columns * grid.rows && !stop.stop_requested(); ++i) {
        const int row = i / grid.columns;
        const double x = (i % grid.columns + 0.5) * width / grid.columns;
        const double y = (row + 0.5) * height / grid.rows;
        // Next to the critical curve the picture is folded ever more narrowly: arrows longer than the way there say nothing.
        const PictureMotion::Place place = (*motion)->at(x, y);
        const auto& move = place.by.front().move;
        if (!move) continue;
        const double right = key.step * move->right, down = key.step * move->down;
        if (std::hypot(right, down) < place.off_critical) arrows_.push_back({x, y, right, down});
    }
}

void ChangeWatch::stop() {
    worker_ = {};  // asks it to stop, and waits for a ray
    works_ = news_ = waits_ = false;
}

void ChangeWatch::forget() {
    stop();
    number_ = -1, key_.clear(), arrows_.clear(), error_.clear();
}

const std::vector<ChangeArrow>& ChangeWatch::arrows() const {
    static const std::vector<ChangeArrow> none;
    return works_ ? none : arrows_;
}

}  // namespace nullscope::viewer
