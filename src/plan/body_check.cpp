#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plan/body_kind.h"
#include "scene/bodies.h"

namespace nullscope {
namespace {

// "" or letters, digits, - and _: what ray data can hold; and nobody else's.
void check_name(const Scene& scene, std::size_t i, const std::string& section, std::vector<SceneFault>& faults) {
    constexpr std::size_t kLongest = 32;
    const std::string& name = scene.bodies[i].name;
    if (name.empty()) return;
    const auto fits = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    };
    if (name.size() > kLongest || !std::all_of(name.begin(), name.end(), fits))
        return faults.push_back({section + ".name", "is not a valid name", "letters, digits, - and _, 32 at most"});
    bool taken = name == "disc" || name == "star";
    for (std::size_t k = 0; k < scene.bodies.size(); ++k)
        taken = taken || (k != i && (k < i || scene.bodies[k].name.empty()) && body_name(scene, k) == name);
    if (taken) faults.push_back({section + ".name", "is the name of another object", "a name of its own"});
}

}  // namespace

// Of wormholes: on its own side.
Vec3 BodyCheck::camera() const {
    const CameraSpec& c = scene.camera;
    const double s = std::sin(c.theta);
    return std::fabs(c.r) * Vec3{s * std::cos(c.phi), s * std::sin(c.phi), std::cos(c.theta)};
}

void check_checker(const Material& material, const std::string& section, std::vector<SceneFault>& faults) {
    if (material.texture == TextureKind::kChecker && material.columns % 2 != 0)
        faults.push_back({section + ".columns", fmt::format("{} cells do not close around the axis", material.columns),
                          "an even number for a checker"});
}

std::vector<SceneFault> check_bodies(const Scene& scene, double horizon) {
    std::vector<SceneFault> faults;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const Body& body = scene.bodies[i];
        const std::string section = body_section(scene, i);
        check_name(scene, i, section, faults);
        if (kind_of(body).has_mapping) check_checker(body.material, section, faults);
        kind_of(body).check(body, {scene, horizon, [&](SceneFault fault) {
                                       fault.key = fmt::format("{}.{}", section, fault.key);
                                       faults.push_back(std::move(fault));
                                   }});
    }
    return faults;
}

}  // namespace nullscope
