// A disc of finite thickness about the polar axis.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plan/body_kind.h"

namespace nullscope {
namespace {

const CylinderSpec& cylinder_of(const Body& body) { return std::get<CylinderSpec>(body.shape); }

std::vector<SceneKey> cylinder_keys() {
    return {
        {"cylinder", "inner", KeyType::kNumber, "r_s", "3", kPositive, "", "Inner radius; below outer.",
         [](auto& s) { return &last_body<CylinderSpec>(s).inner; }},
        {"cylinder", "outer", KeyType::kNumber, "r_s", "8", kPositive, "", "Outer radius.",
         [](auto& s) { return &last_body<CylinderSpec>(s).outer; }},
        {"cylinder", "height", KeyType::kNumber, "r_s", "0.5", kPositive, "",
         "Half its thickness: it fills |z| <= height.", [](auto& s) { return &last_body<CylinderSpec>(s).height; }},
    };
}

void check_cylinder(const Body& body, const BodyCheck& at) {
    const CylinderSpec& c = cylinder_of(body);
    if (!(c.inner < c.outer)) {
        at.report({"inner", fmt::format("inner = {} is not below outer = {}", c.inner, c.outer), "inner < outer"});
        return;
    }
    const Vec3 camera = at.camera();
    const double rho = std::hypot(camera.x, camera.y);
    if (at.camera_is_there(body.far) && std::abs(camera.z) <= c.height && rho >= c.inner && rho <= c.outer)
        at.report({"height", "the camera is inside of the cylinder", "a cylinder beside the camera"});
}

}  // namespace

const BodyKind kCylinderKind{
    .key = CylinderSpec::kName,
    .effect = {Effect::kCylinder, "cylinder", "EFFECT_CYLINDER", "A solid disc of finite thickness ends rays.",
               "there is a [cylinder]", "steps along the ray, at most 128"},
    .make = [] { return Body{CylinderSpec{}}; },
    .keys = cylinder_keys,
    .check = check_cylinder,
    .words =
        [](const Body& body) {
            const CylinderSpec& c = cylinder_of(body);
            return fmt::format("from {} to {}, |z| up to {}", c.inner, c.outer, c.height);
        },
    .extent =
        [](const Body& body) {
            const CylinderSpec& c = cylinder_of(body);
            return BodyExtent{c.inner, std::hypot(c.outer, c.height), std::min(2 * c.height, c.outer - c.inner),
                              c.height};
        },
    .size = [](const Body& body) { return cylinder_of(body).outer; },
    .moves = [](const Body&) -> const char* { return nullptr; },
    .has_mapping = false,
};

}  // namespace nullscope
