#include "gradient/picture_motion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gradient/picture_light.h"
#include "gradient/ray_gradient.h"

namespace nullscope {
namespace {

constexpr int kMostCrossings = 4;           // of the disc's plane, of which one is on the disc or the sky is seen
constexpr double kMotionTolerance = 1e-10;  // of a step
constexpr double kFolded = 1e-9;  // of the product of both sides: what is seen moves along one line whatever turns

using Pair = std::array<double, 2>;

// -(dn/dx)^-1 dn/dp, columns by x and y.
std::optional<Pair> kept_by(const Pair& by_x, const Pair& by_y, const Pair& by_key) {
    const double all = by_x[0] * by_y[1] - by_x[1] * by_y[0];
    const double most = std::hypot(by_x[0], by_x[1]) * std::hypot(by_y[0], by_y[1]);
    if (!(std::fabs(all) > kFolded * most)) return std::nullopt;
    return Pair{(by_y[0] * by_key[1] - by_y[1] * by_key[0]) / all, (by_x[1] * by_key[0] - by_x[0] * by_key[1]) / all};
}

Pair on_disc(const RayGradient::Crossing& crossing, const Change& by) {
    return {derivative(crossing.r, by), crossing.r.value * derivative_of_azimuth(crossing.bearing, by)};
}

// Along two axes of the sky there.
Pair on_sky(const Triple& direction, const Change& by) {
    const Vec3 n{direction[0].value, direction[1].value, direction[2].value},
        moved = derivative_of_direction(direction, by);
    const Vec3 one = normalized(std::fabs(n.z) < 0.7 ? cross(Vec3{0, 0, 1}, n) : cross(Vec3{1, 0, 0}, n));
    return {dot(one, moved), dot(cross(n, one), moved)};
}

}  // namespace

Result<std::unique_ptr<PictureMotion>> PictureMotion::make(const Scene& scene, const std::vector<std::string>& keys) {
    std::unique_ptr<PictureMotion> motion(new PictureMotion);
    motion->scene_ = scene;
    TRY(parameters, parse_parameters(keys, scene));
    motion->keys_ = std::move(*parameters);
    TRY(flow, flow_of(scene.spacetime));
    motion->flow_ = std::move(*flow);
    TRY(view, CameraView::make(motion->scene_, *motion->flow_));
    motion->view_ = *view;
    return motion;
}

PictureMotion::Place PictureMotion::at(double x, double y) const {
    const CameraView::Seen seen = view_->seen(x, y);
    GradientTask task;
    task.time = scene_.time, task.tolerance = kMotionTolerance;
    if (scene_.disc) task.lean = scene_.disc->lean, task.crossings = kMostCrossings;
    const RayGradient found = ray_gradient(*flow_, seen.launch, task);
    const Change by_x = view_->moved(seen, x, y, 1, 0), by_y = view_->moved(seen, x, y, 0, 1);
    const auto first = std::ranges::find_if(found.crossings, [this](const RayGradient::Crossing& crossing) {
        return crossing.r.value >= scene_.disc->inner && crossing.r.value <= scene_.disc->outer;
    });
    const Number shift = found.g * seen.shift;
    const double pixel = std::hypot(by_x.seeds[kSeedAside], by_x.seeds[kSeedAcross]);
    Place place{found.sky.has_value(), found.off_critical / pixel, {}};
    for (const Parameter& key : keys_) {
        const Change by = view_->change(key.kind, seen);
        ByKey& moved = place.by.emplace_back();
        moved.shift = derivative(shift, by);
        if (found.sky)
            moved.sky = derivative_of_direction(found.sky->direction, by),
            moved.delay = derivative(found.sky->delay, by);
        const auto kept = [&](const auto& what) { return kept_by(what(by_x), what(by_y), what(by)); };
        std::optional<Pair> to;
        if (first != found.crossings.end())
            to = kept([&](const Change& change) { return on_disc(*first, change); });
        else if (found.sky)
            to = kept([&](const Change& change) { return on_sky(found.sky->direction, change); });
        if (to) moved.move = {(*to)[0], (*to)[1]};
    }
    return place;
}

}  // namespace nullscope
