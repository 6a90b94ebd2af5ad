#include "scene/observer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "spacetime/circular_orbit.h"

namespace nullscope {
namespace {

Observer boosted(RadialFrame frame, Vec3 first, Vec3 then) {
    if (then == Vec3{}) return {frame, first, {}};
    const BoostAndTurn both = split(boost(first) * boost(then));
    return {frame, both.velocity, both.turn};
}

Result<Observer> falling(const Spacetime& spacetime, double lapse2, double energy, Vec3 velocity, std::string_view who) {
    if (!(energy * energy >= lapse2))
        return bad_input(fmt::format("observer \"{}\" of energy {:.6g} does not come this far in; allowed: camera.r where the energy of rest is less, here it is {:.6g}",
                                     who, energy, std::sqrt(lapse2)));
    const RadialFrame frame = falling_frame(lapse2, energy);
    if (!spacetime.bends_light() && frame.infall() > 0.0)
        return boosted(frame_at_rest(lapse2), {-frame.infall() / frame.energy(), 0.0, 0.0}, velocity);
    return Observer{frame, velocity, {}};
}

}  // namespace

Result<Observer> observer_of(const Spacetime& spacetime, const CameraSpec& camera) {
    const bool rests = camera.observer == ObserverKind::kStatic || camera.observer == ObserverKind::kOrbit;
    if (rests ? !camera_can_rest(spacetime, camera.r) : !camera_can_be(spacetime, camera.r))
        return bad_input(fmt::format("no camera can be {} at camera.r = {}; allowed: {}", rests ? "at rest" : "falling", camera.r,
                                     rests ? allowed_radii(spacetime) : allowed_falling_radii(spacetime)));
    if (spacetime.spin() != 0.0 && camera.observer != ObserverKind::kStatic)
        return bad_input(fmt::format("no observer \"{}\" about a hole that spins yet; allowed: static, with a velocity", observer_name(camera.observer)));
    const double lapse2 = spacetime.lapse_squared(camera.r);
    switch (camera.observer) {
        case ObserverKind::kRain: return falling(spacetime, lapse2, 1.0, camera.velocity, "rain");
        case ObserverKind::kThrow: return falling(spacetime, lapse2, camera.energy, camera.velocity, "throw");
        case ObserverKind::kFall:
            if (!camera_can_rest(spacetime, camera.fall_from) || !(camera.fall_from >= camera.r))
                return bad_input(fmt::format("no camera falls from camera.fall_from = {} to camera.r = {}; allowed: fall_from >= camera.r and {}",
                                             camera.fall_from, camera.r, allowed_radii(spacetime)));
            return falling(spacetime, lapse2, std::sqrt(std::max(spacetime.lapse_squared(camera.fall_from), lapse2)), camera.velocity, "fall");
        case ObserverKind::kOrbit: {
            const auto orbit = spacetime.has_orbit_equation() ? circular_orbit(spacetime, camera.r) : std::nullopt;
            if (!orbit)
                return bad_input(fmt::format("no circular orbit at camera.r = {}; allowed: outside of the photon sphere", camera.r));
            return boosted(frame_at_rest(lapse2), {0.0, 0.0, camera.r * orbit->omega / std::sqrt(lapse2)}, camera.velocity);
        }
        case ObserverKind::kStatic: break;
    }
    return Observer{frame_at_rest(lapse2), camera.velocity, {}};
}

Status check_light_parts(const Spacetime& spacetime, const Scene& scene) {
    const LightSpec& light = scene.light;
    if ((!falls(scene.camera) && spacetime.spin() == 0.0) || (light.lensing && light.doppler && light.gravity && light.aberration)) return Done{};
    if (spacetime.spin() != 0.0)
        return bad_input("a part of light is off about a hole that spins; allowed: light.lensing, doppler, gravity and aberration on, or spin = 0");
    return bad_input(fmt::format("camera.observer = \"{}\" while a part of light is off; allowed: static or orbit with light.lensing, doppler, gravity or aberration = \"off\"",
                                 observer_name(scene.camera.observer)));
}

}  // namespace nullscope
