#include "observer/ring_view.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "observer/critical_light.h"
#include "observer/pose.h"
#include "observer/spin_ring.h"
#include "scene/projection.h"
#include "spacetime/photon_shell.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {
namespace {

// a: a view of kSimilar then lets light go round at least once and a half; windings that grow faster than a logarithm have none.
constexpr double kLeastRate = 0.5, kMostRate = 50.0;
constexpr double kMostRotatingRate = 12.0;  // SPIN_MOST_STEPS of shaders/mino/step.glsl then suffice
constexpr double kLeastClimb = 1e-4;        // 1 - V/q_crit^2 of a camera outside of a barrier

Error view_refused(std::string what, std::string allowed) {
    return bad_key("zoom", std::move(what), std::move(allowed));
}

// A photon sphere's, or the spherical orbit of this point of the ring. Through a barrier's top light passes twice, and inside of it sweeps
// twice as much.
Result<PhotonOrbit> similar_orbit(const Spacetime& spacetime, const CameraSpec& camera) {
    const bool rotates = spacetime.rotates();
    const auto orbit =
        photon_orbit(spacetime, rotates ? camera.theta : 0.5 * std::numbers::pi,
                     rotates ? std::fabs(std::remainder(camera.zoom->angle, 2.0 * std::numbers::pi)) : 0.0);
    if (!orbit)
        return view_refused(orbit.error().what, "a metric with a photon sphere that light can reach, and no tube");
    if (const double rate = std::numbers::pi / orbit->gamma;
        rate > kLeastRate && rate < (rotates ? kMostRotatingRate : kMostRate))
        return *orbit;
    return view_refused("the images of the photon ring shrink too little or too much each",
                        "another parameter of the metric");
}

CameraSpec towards(const CriticalLight& light, CameraSpec camera) {
    const Vec3 seen = light.direction(camera.zoom->angle);  // along the axes of the camera that looks at the centre
    set_direction(camera, -(static_from_camera(CameraSpec{}) * seen));
    camera.zoom.reset();
    return camera;
}

struct Found {
    CameraSpec camera;  // still as wide as without a zoom
    PhotonOrbit orbit;
    double per_pixel;  // e, at most
};

Result<Found> find(const Spacetime& spacetime, const CameraSpec& camera, const LightSpec& light) {
    TRY(orbit, similar_orbit(spacetime, camera));
    CameraSpec ahead = camera;
    ahead.yaw = ahead.pitch = ahead.roll = 0.0;
    TRY(observer, observer_of(spacetime, ahead));
    const auto critical = CriticalLight::make(spacetime, ahead, light);
    if (!critical) return view_refused("light travels straight", "light.lensing = \"on\"");
    const CameraSpec aimed = towards(*critical, camera);
    if (spacetime.rotates()) {
        const double per_pixel = ring_distance_per_pixel(spacetime, aimed, *observer, light);
        return Found{aimed, *orbit, per_pixel};
    }
    CameraSpec still = ahead;
    still.velocity = {};
    if (!falls(camera)) still.observer = ObserverKind::kStatic;
    const Vec3 ring = CriticalLight::make(spacetime, still, light)->direction(0.0);
    // Angles from the critical direction over e, of an observer who does not move across.
    double scale = std::hypot(ring.x, ring.y);
    if (spacetime.spherical()->barrier()) {  // some rays pass the photon sphere twice: there e grows as 1/climb
        const double root_v = spacetime.spherical()->root_v(camera.r) / open_photon_sphere(spacetime)->q_crit,
                     climb = (1.0 - root_v) * (1.0 + root_v);
        if (climb < kLeastClimb)
            return view_refused("the camera is too close to the photon sphere", "camera.r further out");
        scale *= climb;
    }
    const double speed = light.aberration ? length(observer->velocity) : 0.0;
    return Found{aimed, *orbit, aimed.pixel() * std::sqrt((1.0 + speed) / (1.0 - speed)) / scale};
}

}  // namespace

Result<RingView> ring_view(const Spacetime& spacetime, const CameraSpec& camera, const LightSpec& light) {
    TRY(found, find(spacetime, camera, light));
    // e of the corner at most: its logarithm.
    const double corner = std::log(reach_px(camera) * found->per_pixel) - camera.zoom->depth,
                 turn = 2.0 * found->orbit.gamma;
    RingView view{found->camera, std::fmax(std::floor((std::log(kSimilar) - corner) / turn), 0.0)};
    view.depth = camera.zoom->depth;
    view.lag = 2.0 * view.turns * found->orbit.delay;
    view.azimuth = std::remainder(-2.0 * view.turns * found->orbit.azimuth, 2.0 * std::numbers::pi);
    view.half_way = -0.5 * std::numbers::pi / found->orbit.gamma * std::log(kSimilar);
    view.camera.plane_width *= std::exp(view.turns * turn - camera.zoom->depth);
    return view;
}

Result<CameraSpec> without_zoom(const Spacetime& spacetime, const CameraSpec& camera, const LightSpec& light) {
    if (!camera.zoom) return camera;
    TRY(found, find(spacetime, camera, light));
    const double deepest = std::log(found->camera.pixel() / kFinestDirection);
    if (camera.zoom->depth > deepest)
        return bad_key("zoom.depth",
                       fmt::format("at {} a pixel is less than {} rad", camera.zoom->depth, kFinestDirection),
                       fmt::format("at most {:.4g} for this picture, where rays are traced one by one", deepest));
    CameraSpec plain = found->camera;
    plain.plane_width *= std::exp(-camera.zoom->depth);
    return plain;
}

}  // namespace nullscope
