// What ray data and light can be differentiated by, as a scene file's keys, and how each moves what a ray begins with: the chain rule's outer part.
// Camera keys are of a camera that keeps the pixel through which it sees the ray.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "gradient/flow.h"
#include "scene/scene.h"

namespace nullscope {

enum class ParameterKind {
    kSpin,
    kCharge,
    kR,
    kTheta,
    kPhi,
    kYaw,
    kPitch,
    kRoll,
    kFov,
    kTilt,
    kNode,
    kPrecession,
    // Of light alone:
    kVelocityR,
    kVelocityTheta,
    kVelocityPhi,
    kInner,
    kOuter,
    kTemperature,
    kPowers,
    kOpacity,
    kDiscBrightness
};
// Of camera.velocity, 0 to 2; else -1.
int velocity_axis(ParameterKind kind);

// What light has besides rays: seeds of the disc's own numbers, after those of flow.h.
enum LightSeed {
    kSeedInner = kSeeds,
    kSeedOuter,
    kSeedTemperature,
    kSeedPowers,
    kSeedOpacity,
    kSeedBrightness,
    kSeedTurn,   // of all about the polar axis
    kSeedShift,  // ln of the camera's frequency, of what does not come by way of the ray
    kLightSeeds
};
using Shade = Dual<double, kLightSeeds>;

struct Parameter {
    std::string name;  // as it was asked for
    ParameterKind kind;
};

// What may be asked for of this scene: spacetime.spin where the metric has one, disc.* where there is a disc, camera.fov of a pinhole; of light too
// camera.velocity_r, _theta, _phi and the numbers of a thermal disc (of disc.powers the one of a law without breaks).
enum class DerivativesOf { kRays, kLight };
std::vector<std::string_view> parameter_names(const Scene& scene, DerivativesOf of = DerivativesOf::kRays);
// names: of those; "spacetime." may be left out. Errors: others, or one twice, with those that are allowed.
Result<std::vector<Parameter>> parse_parameters(const std::vector<std::string>& names, const Scene& scene,
                                                DerivativesOf of = DerivativesOf::kRays);

// By one unit of the parameter (numbers, r_s, rad, rad per r_s/c, c, K): the seeds, and by how much all turns about the polar axis.
struct Change {
    std::array<double, kLightSeeds> seeds{};
    double turn = 0;
};
// Not of camera.velocity (camera_view.h).
Change change_by(ParameterKind kind, const LookedAlong& view, const Scene& scene);

template <std::size_t n>
double derivative(const Dual<double, n>& number, const Change& change) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i)
        if (change.seeds[i] != 0) sum += number.d[i] * change.seeds[i];
    return sum;
}
inline double derivative_of_azimuth(const Number& azimuth, const Change& change) {
    return derivative(azimuth, change) + change.turn;
}
Vec3 derivative_of_direction(const Triple& direction, const Change& change);

}  // namespace nullscope
