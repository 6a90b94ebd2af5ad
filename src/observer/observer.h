// Who holds the camera: its radial frame, its motion in that frame, and what is left of a turn.
//
// kStatic rests at r. kRain fell from rest at infinity, kFall from rest at fall_from; kThrow falls with `energy` per rest mass. kOrbit
// is on a circular geodesic towards growing phi, kCounterOrbit towards falling phi. `velocity` is a boost on top, along the axes of the
// observer's own frame.
//
// About a rotating hole (observer/spin_frame.h) kStatic rests against the far sky, kZamo has no angular momentum, kCarter sees the
// principal light straight outward and inward; the first two are one without spin, and so is the third. What falls has no angular
// momentum, kFall the energy of kZamo at fall_from.
#pragma once
#include "base/result.h"
#include "observer/lorentz.h"
#include "scene/scene.h"
#include "spacetime/radial_frame.h"
#include "spacetime/spacetime.h"

namespace nullscope {

struct Observer {
    RadialFrame frame;
    double azimuthal_velocity = 0;  // speed along e_phi of the observer's own frame in that; without spin 0
    Vec3 velocity;                  // of the camera in the observer's own frame, along (e_r, e_theta, e_phi)
    Mat3
        turn;  // of the camera's axes, before the boost: what two boosts in different directions leave (Thomas, Wigner)
};

// Where light runs straight the frame is at rest and all motion is in velocity. Errors: no such observer at camera.r, with what is allowed.
Result<Observer> observer_of(const Spacetime& spacetime, const CameraSpec& camera);

// Inward: its frame is not that of an observer at rest, nor at a constant radius.
inline bool falls(const CameraSpec& camera) {
    return camera.observer == ObserverKind::kRain || camera.observer == ObserverKind::kFall ||
           camera.observer == ObserverKind::kThrow;
}

// The parts of light.* that are switched off one by one are parts by observers at rest: not of one that falls, nor about a hole that
// spins. Errors: both.
Status check_light_parts(const Spacetime& spacetime, const Scene& scene);

// The word of scene files.
inline const char* observer_name(ObserverKind kind) {
    constexpr const char* kNames[] = {"static", "rain", "fall", "throw", "orbit", "zamo", "carter", "counter-orbit"};
    return kNames[static_cast<int>(kind)];
}

}  // namespace nullscope
