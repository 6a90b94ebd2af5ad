#include "studio/loop_watch.h"

#include <algorithm>
#include <cmath>

#include "scene/spot_orbit.h"

namespace nullscope::viewer {
namespace {

constexpr int kLoopWidth_px =
    96;  // of which Q and U are summed; twice as many change them by some 0.7 % of the loop's size

}  // namespace

std::string no_loop(const Scene& scene) {
    if (!is_polarised(scene)) return "No light is polarised: disc.polarisation is off.";
    if (scene.split) return "Not for a split screen.";
    return spot_period(scene) ? "" : "Needs a hot spot, [spot].";
}

LoopOrder loop_order(const Scene& scene) {
    LoopOrder order{scene, 0.0, spot_period(scene).value_or(1.0)};
    order.from = order.period * std::floor(scene.time / order.period);
    CameraSpec& camera = order.scene.camera;
    const int height = static_cast<int>(std::lround(1.0 * kLoopWidth_px * camera.height / std::max(camera.width, 1)));
    // Of that many rows and columns all of the picture, whatever shape it has.
    camera.pixel_aspect *=
        static_cast<double>(camera.width) * std::max(height, 1) / (static_cast<double>(camera.height) * kLoopWidth_px);
    camera.width = kLoopWidth_px, camera.height = std::max(height, 1);
    camera.stereo = Stereo::kOff;
    order.scene.path.reset();
    order.scene.time = order.from;
    return order;
}

void LoopWatch::look(const Scene& scene, bool rests) {
    if (!no_loop(scene).empty()) {
        *this = LoopWatch();
        return;
    }
    LoopOrder order = loop_order(scene);
    const double from = order.scene.time;
    order.scene.time = 0.0;
    std::vector<SceneLine> lines = scene_lines(order.scene);
    order.scene.time = from;
    time_ = scene.time;
    of_view_ = lines == lines_;
    if (of_view_ ? from == from_ : !rests) return;
    if (!of_view_) loop_.clear();
    of_view_ = true;
    lines_ = std::move(lines), from_ = from, period_ = order.period, found_ = 0;
    order_ = std::move(order);
}

std::optional<LoopOrder> LoopWatch::take_order() { return std::exchange(order_, std::nullopt); }

void LoopWatch::take(StokesLoop part) {
    if (order_) return;  // it is of another one
    found_ = static_cast<int>(part.size());
    if (found_ >= LoopOrder::kPoints || loop_.size() < part.size()) loop_ = std::move(part);
}

std::optional<StokesPoint> LoopWatch::present() const {
    if (!of_view_ || loop_.size() != LoopOrder::kPoints || !(period_ > 0.0)) return {};
    const double turns = time_ / period_, at = (turns - std::floor(turns)) * (LoopOrder::kPoints - 1);
    const auto before = std::min(static_cast<std::size_t>(at), loop_.size() - 2);
    const double part = at - static_cast<double>(before);
    const StokesPoint &a = loop_[before], &b = loop_[before + 1];
    return StokesPoint{time_, std::lerp(a.i, b.i, part), std::lerp(a.q, b.q, part), std::lerp(a.u, b.u, part)};
}

}  // namespace nullscope::viewer
