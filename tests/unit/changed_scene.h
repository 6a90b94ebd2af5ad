// A scene with one number changed, for differences beside the derivatives of src/gradient.
#pragma once
#include "gradient/parameter.h"
#include "scene/projection.h"
#include "scene/scene.h"

namespace nullscope::test {

// Keys of a disc: of scenes that have one.
inline void change_scene(ParameterKind kind, double by, Scene& scene) {
    CameraSpec& camera = scene.camera;
    switch (kind) {
        case ParameterKind::kSpin: scene.spacetime.parameters["spin"] += by; return;
        case ParameterKind::kCharge: scene.spacetime.parameters["charge"] += by; return;
        case ParameterKind::kR: camera.r += by; return;
        case ParameterKind::kTheta: camera.theta += by; return;
        case ParameterKind::kPhi: camera.phi += by; return;
        case ParameterKind::kYaw: camera.yaw += by; return;
        case ParameterKind::kPitch: camera.pitch += by; return;
        case ParameterKind::kRoll: camera.roll += by; return;
        case ParameterKind::kFov: set_field_of_view(camera, field_of_view(camera) + by); return;
        case ParameterKind::kTilt: scene.disc->lean.tilt += by; return;
        case ParameterKind::kNode: scene.disc->lean.node += by; return;
        case ParameterKind::kPrecession: scene.disc->lean.precession += by; return;
        case ParameterKind::kVelocityR: camera.velocity.x += by; return;
        case ParameterKind::kVelocityTheta: camera.velocity.y += by; return;
        case ParameterKind::kVelocityPhi: camera.velocity.z += by; return;
        case ParameterKind::kInner: scene.disc->inner += by; return;
        case ParameterKind::kOuter: scene.disc->outer += by; return;
        case ParameterKind::kTemperature: scene.disc->temperature_K += by; return;
        case ParameterKind::kPowers: scene.disc->emissivity.powers.x += by; return;
        case ParameterKind::kOpacity: scene.disc->opacity += by; return;
        case ParameterKind::kDiscBrightness: scene.disc->brightness += by; return;
    }
}

}  // namespace nullscope::test
