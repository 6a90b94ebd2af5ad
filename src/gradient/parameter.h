// What ray data can be differentiated by, as a scene file's keys, and how each moves what a ray begins with: the chain rule's outer part. Camera
// keys are of a camera that keeps the pixel through which it sees the ray.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "gradient/flow.h"
#include "scene/scene.h"

namespace nullscope {

enum class ParameterKind { kSpin, kCharge, kR, kTheta, kPhi, kYaw, kPitch, kRoll, kFov, kTilt, kNode, kPrecession };

struct Parameter {
    std::string name;  // as it was asked for
    ParameterKind kind;
};

// What may be asked for of this scene: spacetime.spin where the metric has one, disc.* where there is a disc, camera.fov of a pinhole.
std::vector<std::string_view> parameter_names(const Scene& scene);
// names: of those; "spacetime." may be left out. Errors: others, or one twice, with those that are allowed.
Result<std::vector<Parameter>> parse_parameters(const std::vector<std::string>& names, const Scene& scene);

// By one unit of the parameter (numbers, r_s, rad, rad per r_s/c): the seeds, and by how much all turns about the polar axis.
struct Change {
    std::array<double, kSeeds> seeds{};
    double turn = 0;
};
Change change_by(ParameterKind kind, const LookedAlong& view, const Scene& scene);

inline double derivative(const Number& number, const Change& change) {
    double sum = 0;
    for (std::size_t i = 0; i < kSeeds; ++i)
        if (change.seeds[i] != 0) sum += number.d[i] * change.seeds[i];
    return sum;
}
inline double derivative_of_azimuth(const Number& azimuth, const Change& change) {
    return derivative(azimuth, change) + change.turn;
}
Vec3 derivative_of_direction(const Triple& direction, const Change& change);

}  // namespace nullscope
