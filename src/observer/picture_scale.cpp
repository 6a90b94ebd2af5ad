#include "observer/picture_scale.h"

#include <cmath>

#include "observer/pose.h"
#include "observer/ring_view.h"
#include "scene/projection.h"

namespace nullscope {
namespace {

constexpr double kMostAside = 3.0 * 0.017453292519943295;  // there a pixel spans 0.3 % less

bool at_rest(const CameraSpec& camera) {
    const bool still = camera.observer == ObserverKind::kStatic || camera.observer == ObserverKind::kZamo;
    return still && camera.velocity == Vec3{0, 0, 0};
}

}  // namespace

bool has_scale(const Spacetime& spacetime) { return !spacetime.by_proper_length(); }

double PictureScale::px(double length) const { return 2.0 * std::tan(std::asin(0.5 * length * sine)) / per_px; }

double PictureScale::impact(double off_centre_px) const { return std::sin(std::atan(off_centre_px * per_px)) / sine; }

std::optional<std::array<double, 2>> centre_px(const Spacetime& spacetime, const CameraSpec& camera) {
    const auto seen = without_zoom(spacetime, camera, {});
    if (!seen) return std::nullopt;
    return pixel_of(*seen, transposed(static_from_camera(*seen)) * Vec3{-1.0, 0.0, 0.0});
}

std::optional<PictureScale> picture_scale(const Spacetime& spacetime, const CameraSpec& camera) {
    if (!projection_of(camera).flat || camera.pixel_aspect != 1.0) return std::nullopt;
    if (!has_scale(spacetime) || !at_rest(camera) || !(camera.r >= kLeastScaleRadius)) return std::nullopt;
    if (std::cos(camera.yaw) * std::cos(camera.pitch) < std::cos(kMostAside)) return std::nullopt;
    return PictureScale{std::sqrt(spacetime.lapse_squared(camera.r)) / spacetime.areal_radius(camera.r),
                        camera.pixel()};
}

}  // namespace nullscope
