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

Result<std::unique_ptr<PictureMotion>> PictureMotion::make(const Scene& scene, const std::string& key) {
    std::unique_ptr<PictureMotion> motion(new PictureMotion);
    motion->scene_ = scene;
    TRY(parameters, parse_parameters({key}, scene));
    motion->kind_ = parameters->front().kind;
    TRY(flow, flow_of(scene.spacetime));
    motion->flow_ = std::move(*flow);
    TRY(view, CameraView::make(motion->scene_, *motion->flow_));
    motion->view_ = *view;
    return motion;
}

std::optional<PictureMotion::Place> PictureMotion::at(double x, double y) const {
    const CameraView::Seen seen = view_->seen(x, y);
    GradientTask task;
    task.time = scene_.time, task.tolerance = kMotionTolerance;
    if (scene_.disc) task.lean = scene_.disc->lean, task.crossings = kMostCrossings;
    const RayGradient found = ray_gradient(*flow_, seen.launch, task);
    const Change by_x = view_->moved(seen, x, y, 1, 0), by_y = view_->moved(seen, x, y, 0, 1),
                 by_key = view_->change(kind_, seen);
    const auto is_on = [this](const auto& crossing) {
        return crossing.r.value >= scene_.disc->inner && crossing.r.value <= scene_.disc->outer;
    };
    std::optional<Pair> moved;
    if (const auto first = std::ranges::find_if(found.crossings, is_on); first != found.crossings.end())
        moved = kept_by(on_disc(*first, by_x), on_disc(*first, by_y), on_disc(*first, by_key));
    else if (found.sky)
        moved = kept_by(on_sky(found.sky->direction, by_x), on_sky(found.sky->direction, by_y),
                        on_sky(found.sky->direction, by_key));
    if (!moved) return std::nullopt;
    const double pixel = std::hypot(by_x.seeds[kSeedAside], by_x.seeds[kSeedAcross]);
    return Place{(*moved)[0], (*moved)[1], found.off_critical / pixel};
}

}  // namespace nullscope
