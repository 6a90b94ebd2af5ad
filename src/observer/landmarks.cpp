#include "observer/landmarks.h"

#include <cmath>
#include <numbers>

#include "observer/critical_light.h"
#include "observer/observer.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {
namespace {

// alpha^2 = -1/g^tt, which is regular in an ergosphere.
std::optional<double> lapse_at(const Spacetime& spacetime, double r, double theta) {
    if (spacetime.planar_rays()) {
        const double squared = spacetime.lapse_squared(r);
        return squared > 0.0 ? std::optional(std::sqrt(squared)) : std::nullopt;
    }
    if (r <= spacetime.horizon_radius().value_or(0.0)) return std::nullopt;
    const double inverse = spacetime.inverse_metric(r, theta)[0][0];
    return inverse < 0.0 ? std::optional(1.0 / std::sqrt(-inverse)) : std::nullopt;
}

std::optional<double> shadow_at(const Spacetime& spacetime, double r) {
    const auto sphere = open_photon_sphere(spacetime);
    if (!spacetime.planar_rays() || !sphere || !(spacetime.lapse_squared(r) > 0.0)) return std::nullopt;
    const double sine = std::sqrt(spacetime.lapse_squared(r)) / spacetime.areal_radius(r) / sphere->q_crit;
    const double angle = std::asin(std::fmin(std::fabs(sine), 1.0));
    return r >= sphere->radius ? angle : std::numbers::pi - angle;
}

// The curve is the same above and below: its height is twice that of its top, its width lies between the angles 0 and pi.
std::optional<std::array<double, 2>> shadow_size_at(const Spacetime& spacetime, const CameraSpec& camera) {
    if (spacetime.planar_rays()) return std::nullopt;
    CameraSpec zamo;
    zamo.r = camera.r, zamo.theta = camera.theta, zamo.observer = ObserverKind::kZamo;
    const auto curve = CriticalLight::make(spacetime, zamo, {});
    if (!curve) return std::nullopt;
    const auto height = [&](double angle) { return std::asin(std::fabs(curve->direction(angle).y)); };
    double low = 0.0, high = std::numbers::pi;  // the top is between them: thirds of it are left out
    while (high - low > 1e-6) {
        const double third = (high - low) / 3.0;
        if (height(low + third) < height(high - third))
            low += third;
        else
            high -= third;
    }
    const Vec3 one = curve->direction(0.0), other = curve->direction(std::numbers::pi), top = curve->direction(low);
    if (!(one.z < 0.0 && other.z < 0.0 && top.z < 0.0)) return std::nullopt;
    return std::array{std::fabs(std::atan2(one.x, -one.z) - std::atan2(other.x, -other.z)), 2.0 * height(low)};
}

// Outside of a horizon.
std::optional<double> planar_clock_rate(const Spacetime& spacetime, const CameraSpec& camera) {
    const auto observer = observer_of(spacetime, camera);
    if (!observer) return std::nullopt;
    const double speed = length(observer->velocity), slow = std::sqrt((1.0 - speed) * (1.0 + speed));
    const RadialFrame& frame = observer->frame;
    return spacetime.lapse_squared(camera.r) * slow / (frame.energy() - frame.infall() * observer->velocity.x);
}

}  // namespace

Landmarks landmarks_of(const Spacetime& spacetime) {
    Landmarks found;
    found.horizon = spacetime.horizon_radius();
    found.singular = found.horizon && !(spacetime.areal_radius(*found.horizon) > 0.0);
    if (const auto sphere = open_photon_sphere(spacetime))
        found.photon_orbit = sphere->radius, found.critical_impact = 1.0 / sphere->q_crit;
    else if (spacetime.rotates() && found.horizon)
        found.photon_orbit = light_orbit(spacetime);
    if (spacetime.can_have_disc() && !spacetime.by_proper_length()) found.isco = innermost_stable_orbit(spacetime);
    if (spacetime.rotates() && found.horizon) {
        found.retrograde_photon_orbit = light_orbit(spacetime, Sense::kWestward);
        found.retrograde_isco = innermost_stable_orbit(spacetime, Sense::kWestward);
    }
    return found;
}

CameraNumbers camera_numbers(const Spacetime& spacetime, const CameraSpec& camera) {
    CameraNumbers found;
    found.lapse = lapse_at(spacetime, camera.r, camera.theta);
    found.shadow = shadow_at(spacetime, camera.r);
    found.shadow_size = shadow_size_at(spacetime, camera);
    const auto orbit = circular_orbit(spacetime, camera.r);
    if (orbit && found.lapse && orbit->omega != 0.0) {
        const double slowness = 1.0 / (*found.lapse * orbit->u_t);  // 1/gamma by observers without angular momentum
        found.orbit_period = 2.0 * std::numbers::pi / std::fabs(orbit->omega);
        if (spacetime.planar_rays()) found.orbit_speed = std::sqrt((1.0 - slowness) * (1.0 + slowness));
    }
    const double speed = length(camera.velocity), slow = std::sqrt((1.0 - speed) * (1.0 + speed));
    if (!spacetime.planar_rays() && camera.observer == ObserverKind::kZamo && found.lapse)
        found.clock_rate = *found.lapse * slow;
    if (spacetime.planar_rays() && found.lapse) found.clock_rate = planar_clock_rate(spacetime, camera);
    return found;
}

}  // namespace nullscope
