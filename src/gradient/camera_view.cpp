#include "gradient/camera_view.h"

#include <fmt/format.h>

#include <cmath>

#include "observer/observer.h"
#include "observer/pose.h"
#include "scene/projection.h"

namespace nullscope {
namespace {

template <class Value>
struct Boosted {
    std::array<Value, 3> n;
    Value shift;  // frequency in what moves over frequency in the frame
};

// A direction n that light comes from, as it is in a frame in which the camera moves with v.
template <class Value>
Boosted<Value> boosted_view(const std::array<Value, 3>& n, const std::array<Value, 3>& v) {
    const Value along = n[0] * v[0] + n[1] * v[1] + n[2] * v[2], speed2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    const Value gamma = 1.0 / sqrt(1.0 - speed2), seen = gamma * (1.0 - along);
    const Value more = gamma * gamma / (1.0 + gamma) * along - gamma;
    std::array<Value, 3> there;
    for (std::size_t i = 0; i < 3; ++i) there[i] = (n[i] + more * v[i]) / seen;
    return {there, 1.0 / seen};
}

template <class Value>
std::array<Value, 3> constants(Vec3 v) {
    return {Value(v.x), Value(v.y), Value(v.z)};
}
Vec3 values_of(const Triple& n) { return {n[0].value, n[1].value, n[2].value}; }
Vec3 by_seed(const Triple& n, Seed seed) { return {n[0].d[seed], n[1].d[seed], n[2].d[seed]}; }

// Turns about aside and across that move n there so.
Change turns_for(const Triple& n, Vec3 moved) {
    const Vec3 a = by_seed(n, kSeedAside), b = by_seed(n, kSeedAcross);
    const double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b), ma = dot(moved, a), mb = dot(moved, b);
    const double all = aa * bb - ab * ab;
    Change change;
    change.seeds[kSeedAside] = (bb * ma - ab * mb) / all, change.seeds[kSeedAcross] = (aa * mb - ab * ma) / all;
    return change;
}

}  // namespace

Result<CameraView> CameraView::make(const Scene& scene, const Flow& flow) {
    const CameraSpec& camera = scene.camera;
    const ObserverKind kind = camera.observer;
    if (kind != ObserverKind::kStatic && kind != ObserverKind::kZamo)
        return bad_key("camera.observer", fmt::format("\"{}\": no derivatives of what it sees", observer_name(kind)),
                       "static or zamo, with or without a camera.velocity");
    if (camera.projection != Projection::kPinhole || !camera.warp.empty() || camera.zoom ||
        camera.stereo != Stereo::kOff)
        return bad_key("camera.projection", "no derivatives of such a picture",
                       "pinhole, without zoom, warp and stereo");
    const LightSpec& light = scene.light;
    if (!(light.doppler && light.gravity && light.aberration && light.lensing))
        return bad_key("light", "no derivatives with a part of it off", "doppler, gravity, aberration and lensing on");
    CameraView view(scene, flow);
    if (!std::isfinite(view.seen(0.5 * camera.width, 0.5 * camera.height).launch.view[0].value))
        return bad_key("camera.r", fmt::format("no {} observer at {} r_s", observer_name(kind), camera.r),
                       "outside of the horizon; static: and of the ergosphere");
    return view;
}

// Of an observer at rest against the far sky, by one without angular momentum: those are dragged by -g_tphi/g_phiphi.
Number CameraView::azimuthal_speed() const {
    const CameraSpec& camera = scene_->camera;
    if (camera.observer == ObserverKind::kZamo) return Number(0.0);
    const Number r = Number::variable(camera.r, kSeedR), cosine = cos(Number::variable(camera.theta, kSeedTheta));
    const PlaceNumbers m = flow_->place(r, cosine);
    return m.tphi / sqrt(m.tphi * m.tphi - m.tt * m.phiphi);
}

CameraView::Seen CameraView::seen(double x, double y) const {
    const CameraSpec& camera = scene_->camera;
    const LookedAlong own = looked_along(normalized(static_from_camera(camera) * pixel_direction(camera, x, y)));
    const auto first = boosted_view(turning(own), constants<Number>(camera.velocity));
    const auto second = boosted_view<Number>(first.n, {Number(0.0), Number(0.0), azimuthal_speed()});
    return {own, Launch(camera.r, camera.theta, camera.phi, second.n), first.shift * second.shift};
}

Change CameraView::change(ParameterKind kind, const Seen& seen) const {
    const int axis = velocity_axis(kind);
    if (axis < 0) return change_by(kind, seen.own, *scene_);
    // n moves as by a turn, which would change the shift too.
    using ByVelocity = Dual<double, 3>;
    const Vec3& v = scene_->camera.velocity;
    const auto by = boosted_view<ByVelocity>(
        constants<ByVelocity>(seen.own.n),
        {ByVelocity::variable(v.x, 0), ByVelocity::variable(v.y, 1), ByVelocity::variable(v.z, 2)});
    const auto first = boosted_view(turning(seen.own), constants<Number>(v));
    const auto i = static_cast<std::size_t>(axis);
    Change change = turns_for(first.n, {by.n[0].d[i], by.n[1].d[i], by.n[2].d[i]});
    change.seeds[kSeedShift] = (by.shift.d[i] - derivative(first.shift, change)) / first.shift.value;
    return change;
}

Change CameraView::moved(const Seen& seen, double x, double y, double by_x, double by_y) const {
    // A pinhole's direction is linear in the place.
    const CameraSpec& camera = scene_->camera;
    const Vec3 here = pixel_direction(camera, x, y), there = pixel_direction(camera, x + by_x, y + by_y);
    const Vec3 step = static_from_camera(camera) * (there - here) / length(here);
    Change change;
    change.seeds[kSeedAside] = dot(seen.own.aside, step), change.seeds[kSeedAcross] = dot(seen.own.across, step);
    return change;
}

std::optional<std::array<double, 2>> CameraView::hole() const {
    const CameraSpec& camera = scene_->camera;
    const auto first =
        boosted_view<Number>({Number(-1.0), Number(0.0), Number(0.0)}, {Number(0.0), Number(0.0), -azimuthal_speed()});
    const auto second = boosted_view(first.n, constants<Number>(-camera.velocity));
    return pixel_of(camera, transposed(static_from_camera(camera)) * values_of(second.n));
}

}  // namespace nullscope
