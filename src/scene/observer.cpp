#include "scene/observer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "spacetime/circular_orbit.h"
#include "spacetime/spin_frame.h"

namespace nullscope {
namespace {

Observer boosted(RadialFrame frame, Vec3 first, Vec3 then) {
    if (then == Vec3{}) return {frame, 0.0, first, {}};
    const BoostAndTurn both = split(boost(first) * boost(then));
    return {frame, 0.0, both.velocity, both.turn};
}

Error comes_no_further(std::string_view who, double energy, double lapse2) {
    return bad_input(
        fmt::format("observer \"{}\" of energy {:.6g} does not come this far in; allowed: camera.r where the energy of "
                    "rest is less, here it is {:.6g}",
                    who, energy, std::sqrt(lapse2)));
}

Result<Observer> falling(const Spacetime& spacetime, double lapse2, double energy, Vec3 velocity,
                         std::string_view who) {
    if (!(energy * energy >= lapse2)) return comes_no_further(who, energy, lapse2);
    const RadialFrame frame = falling_frame(lapse2, energy);
    if (!spacetime.bends_light() && frame.infall() > 0.0)
        return boosted(frame_at_rest(lapse2), {-frame.infall() / frame.energy(), 0.0, 0.0}, velocity);
    return Observer{frame, 0.0, velocity, {}};
}

// About a rotating hole; of its place what does not depend on the spin is checked.
Result<Observer> axial_observer(const AxialMetric& metric, const CameraSpec& camera) {
    const SpinPlace place = spin_place(metric, camera.r, camera.theta);
    const auto observer = [&](const SpinFrame& frame) {
        return Observer{frame.radial, frame.swirl, camera.velocity, {}};
    };
    switch (camera.observer) {
        case ObserverKind::kStatic:
            if (const auto frame = static_frame(place)) return observer(*frame);
            return bad_input(
                fmt::format("nobody is at rest at camera.r = {}, in the ergosphere; allowed: r > {} at this theta, or "
                            "observer = \"zamo\"",
                            camera.r, static_limit(metric, camera.theta)));
        case ObserverKind::kZamo: return observer(zamo_frame(place));
        case ObserverKind::kCarter: return observer(carter_frame(place));
        case ObserverKind::kOrbit:
        case ObserverKind::kCounterOrbit:
            if (const auto frame = orbiting_frame(place, camera.observer == ObserverKind::kOrbit))
                return observer(*frame);
            return bad_input(fmt::format(
                "no orbit of this sense at camera.r = {}; allowed: outside of light's own orbit of this sense",
                camera.r));
        case ObserverKind::kRain:
        case ObserverKind::kFall:
        case ObserverKind::kThrow: break;
    }
    const double lapse2 = zamo_lapse2(place);
    double energy = camera.observer == ObserverKind::kThrow ? camera.energy : 1.0;
    if (camera.observer == ObserverKind::kFall)
        energy = std::sqrt(std::max(zamo_lapse2(spin_place(metric, camera.fall_from, camera.theta)), lapse2));
    if (!(energy * energy >= lapse2)) return comes_no_further(observer_name(camera.observer), energy, lapse2);
    return observer(falling_frame(place, energy));
}

}  // namespace

Result<Observer> observer_of(const Spacetime& spacetime, const CameraSpec& camera) {
    const bool rests = !falls(camera);
    if (rests ? !camera_can_rest(spacetime, camera.r) : !camera_can_be(spacetime, camera.r))
        return bad_input(fmt::format("no camera can be {} at camera.r = {}; allowed: {}", rests ? "at rest" : "falling",
                                     camera.r, rests ? allowed_radii(spacetime) : allowed_falling_radii(spacetime)));
    if (camera.observer == ObserverKind::kFall &&
        (!camera_can_rest(spacetime, camera.fall_from) || !(camera.fall_from >= camera.r)))
        return bad_input(fmt::format(
            "no camera falls from camera.fall_from = {} to camera.r = {}; allowed: fall_from >= camera.r and {}",
            camera.fall_from, camera.r, allowed_radii(spacetime)));
    if (const AxialMetric* metric = spacetime.axial()) return axial_observer(*metric, camera);
    const double lapse2 = spacetime.lapse_squared(camera.r);
    switch (camera.observer) {
        case ObserverKind::kRain: return falling(spacetime, lapse2, 1.0, camera.velocity, "rain");
        case ObserverKind::kThrow: return falling(spacetime, lapse2, camera.energy, camera.velocity, "throw");
        case ObserverKind::kFall:
            return falling(spacetime, lapse2, std::sqrt(std::max(spacetime.lapse_squared(camera.fall_from), lapse2)),
                           camera.velocity, "fall");
        case ObserverKind::kOrbit:
        case ObserverKind::kCounterOrbit: {
            const auto orbit = circular_orbit(spacetime, camera.r);
            if (!orbit)
                return bad_input(
                    fmt::format("no circular orbit at camera.r = {}; allowed: outside of the photon sphere", camera.r));
            const double speed = camera.r * orbit->omega / std::sqrt(lapse2);
            return boosted(frame_at_rest(lapse2), {0.0, 0.0, camera.observer == ObserverKind::kOrbit ? speed : -speed},
                           camera.velocity);
        }
        case ObserverKind::kZamo:
        case ObserverKind::kCarter:
        case ObserverKind::kStatic: break;
    }
    return Observer{frame_at_rest(lapse2), 0.0, camera.velocity, {}};
}

Status check_light_parts(const Spacetime& spacetime, const Scene& scene) {
    const LightSpec& light = scene.light;
    if ((!falls(scene.camera) && spacetime.planar_rays()) ||
        (light.lensing && light.doppler && light.gravity && light.aberration))
        return Done{};
    if (!spacetime.planar_rays())
        return bad_input(
            "a part of light is off about a rotating hole; allowed: light.lensing, doppler, gravity and aberration "
            "on, or spin = 0");
    return bad_input(
        fmt::format("camera.observer = \"{}\" while a part of light is off; allowed: static or orbit with "
                    "light.lensing, doppler, gravity or aberration = \"off\"",
                    observer_name(scene.camera.observer)));
}

}  // namespace nullscope
