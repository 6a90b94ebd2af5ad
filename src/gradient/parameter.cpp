#include "gradient/parameter.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "observer/pose.h"
#include "scene/projection.h"
#include "spacetime/registry.h"

namespace nullscope {
namespace {

// In the order of ParameterKind; the first kOfRays also of rays.
constexpr std::array<std::string_view, 21> kNames = {"spacetime.spin",
                                                     "spacetime.charge",
                                                     "camera.r",
                                                     "camera.theta",
                                                     "camera.phi",
                                                     "camera.yaw",
                                                     "camera.pitch",
                                                     "camera.roll",
                                                     "camera.fov",
                                                     "disc.tilt",
                                                     "disc.node",
                                                     "disc.precession",
                                                     "camera.velocity_r",
                                                     "camera.velocity_theta",
                                                     "camera.velocity_phi",
                                                     "disc.inner",
                                                     "disc.outer",
                                                     "disc.temperature",
                                                     "disc.powers",
                                                     "disc.opacity",
                                                     "disc.brightness"};
constexpr std::size_t kOfRays = 12;
constexpr std::string_view kSpacetime = "spacetime.";

bool is_there(std::string_view name, const Scene& scene) {
    if (name == "disc.temperature") return scene.disc && !scene.disc->accretion;
    if (name == "disc.powers")
        return scene.disc && scene.disc->emissivity.by == Emissivity::kPowerLaw &&
               scene.disc->emissivity.breaks.empty();
    if (name.starts_with("disc.")) return scene.disc.has_value();
    if (name == "camera.fov") return scene.camera.projection == Projection::kPinhole;
    if (!name.starts_with(kSpacetime)) return true;
    const MetricEntry* entry = find_metric(scene.spacetime.metric);
    return entry != nullptr && std::ranges::any_of(entry->parameters, [&](const MetricParameter& parameter) {
               return parameter.name == name.substr(kSpacetime.size());
           });
}

// n turned about this axis of the local frame.
Change turned(const LookedAlong& view, Vec3 moved) {
    Change change;
    change.seeds[kSeedAside] = dot(view.aside, moved), change.seeds[kSeedAcross] = dot(view.across, moved);
    return change;
}

// A direction (x, y, -1) over its length, where x and y are in proportion to tan(fov/2): d ln tan(fov/2)/dfov = 1/sin(fov).
Vec3 widened(Vec3 n, const CameraSpec& camera) {
    const Mat3 axes = static_from_camera(camera);
    const Vec3 own = transposed(axes) * n, wider{own.x, own.y, 0};
    return axes * (wider - dot(own, wider) * own) / std::sin(field_of_view(camera));
}

}  // namespace

int velocity_axis(ParameterKind kind) {
    const int axis = static_cast<int>(kind) - static_cast<int>(ParameterKind::kVelocityR);
    return axis >= 0 && axis < 3 ? axis : -1;
}

std::vector<std::string_view> parameter_names(const Scene& scene, DerivativesOf of) {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < (of == DerivativesOf::kRays ? kOfRays : kNames.size()); ++i)
        if (is_there(kNames[i], scene)) names.push_back(kNames[i]);
    return names;
}

Result<std::vector<Parameter>> parse_parameters(const std::vector<std::string>& names, const Scene& scene,
                                                DerivativesOf of) {
    const std::vector<std::string_view> known = parameter_names(scene, of);
    std::vector<Parameter> parameters;
    for (const std::string& name : names) {
        const auto is_it = [&](std::string_view key) { return key == name || key == std::string(kSpacetime) + name; };
        const auto found = std::ranges::find_if(known, is_it);
        const std::string allowed = fmt::format("{}, each once", fmt::join(known, ", "));
        if (found == known.end())
            return bad_input(fmt::format("no derivatives by {} of this scene", in_quotes(name)), allowed);
        const auto kind = static_cast<ParameterKind>(std::ranges::find(kNames, *found) - kNames.begin());
        if (std::ranges::any_of(parameters, [&](const Parameter& other) { return other.kind == kind; }))
            return bad_input(fmt::format("derivatives by {} twice", in_quotes(name)), allowed);
        parameters.push_back({name, kind});
    }
    return parameters;
}

// Turns as observer/pose.h has them: yaw about the local e_theta, pitch about the right axis after that, roll about the line of sight.
Change change_by(ParameterKind kind, const LookedAlong& view, const Scene& scene) {
    const CameraSpec& camera = scene.camera;
    const auto seed = [](int of, double by = 1) {
        Change change;
        change.seeds[static_cast<std::size_t>(of)] = by;
        return change;
    };
    switch (kind) {
        case ParameterKind::kSpin: return seed(kSeedSpin);
        case ParameterKind::kCharge: return seed(kSeedCharge);
        case ParameterKind::kR: return seed(kSeedR);
        case ParameterKind::kTheta: return seed(kSeedTheta);
        case ParameterKind::kPhi: {  // as if the disc turned the other way, and then all
            Change change = seed(kSeedNode, -1);
            change.turn = change.seeds[kSeedTurn] = 1;
            return change;
        }
        case ParameterKind::kYaw: return turned(view, cross(Vec3{0, 1, 0}, view.n));
        case ParameterKind::kPitch:
            return turned(view, cross(Vec3{std::sin(camera.yaw), 0, std::cos(camera.yaw)}, view.n));
        case ParameterKind::kRoll: return turned(view, cross(-static_from_camera(camera).c, view.n));
        case ParameterKind::kFov: return turned(view, widened(view.n, camera));
        case ParameterKind::kTilt: return seed(kSeedTilt);
        case ParameterKind::kNode: return seed(kSeedNode);
        case ParameterKind::kPrecession: return seed(kSeedNode, scene.time);
        case ParameterKind::kInner: return seed(kSeedInner);
        case ParameterKind::kOuter: return seed(kSeedOuter);
        case ParameterKind::kTemperature: return seed(kSeedTemperature);
        case ParameterKind::kPowers: return seed(kSeedPowers);
        case ParameterKind::kOpacity: return seed(kSeedOpacity);
        case ParameterKind::kDiscBrightness: return seed(kSeedBrightness);
        case ParameterKind::kVelocityR:
        case ParameterKind::kVelocityTheta:
        case ParameterKind::kVelocityPhi: break;
    }
    return {};
}

Vec3 derivative_of_direction(const Triple& direction, const Change& change) {
    return {derivative(direction[0], change) - change.turn * direction[1].value,
            derivative(direction[1], change) + change.turn * direction[0].value, derivative(direction[2], change)};
}

}  // namespace nullscope
