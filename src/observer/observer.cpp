#include "observer/observer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "observer/spin_frame.h"
#include "spacetime/circular_orbit.h"

namespace nullscope {
namespace {

Observer boosted(RadialFrame frame, Vec3 first, Vec3 then) {
    if (then == Vec3{}) return {frame, 0.0, first, {}};
    const BoostAndTurn both = split(boost(first) * boost(then));
    return {frame, 0.0, both.velocity, both.turn};
}

Error refused(std::string what, std::string allowed) {
    return bad_key("camera.observer", std::move(what), std::move(allowed));
}

// Of a camera that falls, per rest mass; lapse2_at(r): the energy squared of rest there.
template <class LapseAt>
Result<double> falling_energy(const CameraSpec& camera, const LapseAt& lapse2_at) {
    const double lapse2 = lapse2_at(camera.r);
    double energy = camera.observer == ObserverKind::kThrow ? camera.energy : 1.0;
    if (camera.observer == ObserverKind::kFall) energy = std::sqrt(std::max(lapse2_at(camera.fall_from), lapse2));
    if (energy * energy >= lapse2) return energy;
    return refused(fmt::format("observer \"{}\" of energy {:.6g} does not come this far in",
                               observer_name(camera.observer), energy),
                   fmt::format("camera.r where the energy of rest is less, here it is {:.6g}", std::sqrt(lapse2)));
}

Result<Observer> falling(const Spacetime& spacetime, const CameraSpec& camera) {
    TRY(energy, falling_energy(camera, [&](double r) { return spacetime.lapse_squared(r); }));
    const double lapse2 = spacetime.lapse_squared(camera.r);
    const RadialFrame frame = falling_frame(lapse2, *energy);
    if (!spacetime.bends_light() && frame.infall() > 0.0)
        return boosted(frame_at_rest(lapse2), {-frame.infall() / frame.energy(), 0.0, 0.0}, camera.velocity);
    return Observer{frame, 0.0, camera.velocity, {}};
}

// About a rotating hole; of its place what does not depend on the spin is checked.
Result<Observer> axial_observer(const AxialMetric& metric, const CameraSpec& camera) {
    const SpinPlace place = spin_place(metric, camera.r, camera.theta);
    const auto observer = [&](const SpinFrame& frame) {
        return Observer{frame.radial, frame.azimuthal_velocity, camera.velocity, {}};
    };
    switch (camera.observer) {
        case ObserverKind::kStatic:
            if (const auto frame = static_frame(place)) return observer(*frame);
            return refused(
                fmt::format("nobody is at rest at camera.r = {}, in the ergosphere", camera.r),
                fmt::format("r > {} at this theta, or observer = \"zamo\"", static_limit(metric, camera.theta)));
        case ObserverKind::kZamo: return observer(zamo_frame(place));
        case ObserverKind::kCarter: return observer(carter_frame(place));
        case ObserverKind::kOrbit:
        case ObserverKind::kCounterOrbit:
            if (const auto frame = orbiting_frame(place, camera.observer == ObserverKind::kOrbit))
                return observer(*frame);
            return refused(fmt::format("no orbit of this sense at camera.r = {}", camera.r),
                           "outside of light's own orbit of this sense");
        case ObserverKind::kRain:
        case ObserverKind::kFall:
        case ObserverKind::kThrow: break;
    }
    TRY(energy, falling_energy(camera, [&](double r) { return zamo_lapse2(spin_place(metric, r, camera.theta)); }));
    return observer(falling_frame(place, *energy));
}

Result<Observer> any_observer(const Spacetime& spacetime, const CameraSpec& camera) {
    const bool rests = !falls(camera);
    if (rests ? !camera_can_rest(spacetime, camera.r) : !camera_can_be(spacetime, camera.r))
        return refused(fmt::format("no camera can be {} at camera.r = {}", rests ? "at rest" : "falling", camera.r),
                       rests ? allowed_radii(spacetime) : allowed_falling_radii(spacetime));
    if (camera.observer == ObserverKind::kFall &&
        (!camera_can_rest(spacetime, camera.fall_from) || !(camera.fall_from >= camera.r)))
        return refused(
            fmt::format("no camera falls from camera.fall_from = {} to camera.r = {}", camera.fall_from, camera.r),
            fmt::format("fall_from >= camera.r and {}", allowed_radii(spacetime)));
    if (const AxialMetric* metric = spacetime.axial()) return axial_observer(*metric, camera);
    if (!rests) return falling(spacetime, camera);
    const double lapse2 = spacetime.lapse_squared(camera.r);
    const bool onward = camera.observer == ObserverKind::kOrbit;
    if (!onward && camera.observer != ObserverKind::kCounterOrbit)
        return Observer{frame_at_rest(lapse2), 0.0, camera.velocity, {}};
    const auto orbit = circular_orbit(spacetime, camera.r);
    if (!orbit)
        return refused(fmt::format("no circular orbit at camera.r = {}", camera.r), "outside of the photon sphere");
    const double speed = camera.r * orbit->omega / std::sqrt(lapse2);
    return boosted(frame_at_rest(lapse2), {0.0, 0.0, onward ? speed : -speed}, camera.velocity);
}

}  // namespace

Result<Observer> observer_of(const Spacetime& spacetime, const CameraSpec& camera) {
    TRY(observer, any_observer(spacetime, camera));
    // Orbits next to the photon sphere, and what is boosted there: rounding may leave no difference to light.
    if (length(observer->velocity) < 1.0) return observer;
    return refused("the camera is as fast as light to the last digit",
                   "camera.r further from the photon sphere, or a lower camera.velocity");
}

Status check_light_parts(const Spacetime& spacetime, const Scene& scene) {
    const LightSpec& light = scene.light;
    if ((!falls(scene.camera) && spacetime.planar_rays()) ||
        (light.lensing && light.doppler && light.gravity && light.aberration))
        return Done{};
    const char* part = !light.lensing   ? "light.lensing"
                       : !light.doppler ? "light.doppler"
                       : !light.gravity ? "light.gravity"
                                        : "light.aberration";
    if (!spacetime.planar_rays())
        return bad_key(part, "off, which is not supported about a rotating hole",
                       "light.lensing, doppler, gravity and aberration on, or spin = 0");
    return bad_key("camera.observer", fmt::format("\"{}\" while {} is off", observer_name(scene.camera.observer), part),
                   "static or orbit with light.lensing, doppler, gravity or aberration = \"off\"");
}

}  // namespace nullscope
