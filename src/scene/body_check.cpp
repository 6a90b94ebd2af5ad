#include "scene/body_check.h"

#include <fmt/format.h>

#include <cmath>

#include "expr/formula.h"
#include "scene/named_surface.h"

namespace nullscope {
namespace {

using Given = std::function<bool(const std::string&)>;
using Faults = std::vector<BodyFault>;

Vec3 camera_at(const CameraSpec& camera) {
    const double s = std::sin(camera.theta);
    return camera.r * Vec3{s * std::cos(camera.phi), s * std::sin(camera.phi), std::cos(camera.theta)};
}

// A key that another key's value calls for, or rules out.
void check_partner(const std::string& key, bool wanted, bool needed, const std::string& partner, const Given& given,
                   Faults& faults) {
    if (wanted && needed && !given(key)) faults.push_back({key, fmt::format("missing, but {}", partner), "a value"});
    if (!wanted && given(key)) faults.push_back({key, "has no meaning here", fmt::format("with {} only", partner)});
}

void check_look(const std::string& section, const BodyLook& look, const Given& given, Faults& faults) {
    const auto of = [&](const char* key) { return fmt::format("{}.{}", section, key); };
    const TextureKind kind = look.texture;
    const bool plain = kind == TextureKind::kPlain, image = kind == TextureKind::kImage,
               formula = kind == TextureKind::kFormula;
    check_partner(of("image"), image, true, "texture = \"image\"", given, faults);
    check_partner(of("formula"), formula, true, "texture = \"formula\"", given, faults);
    const bool counted = !plain && !image && !formula;
    check_partner(of("columns"), counted && kind != TextureKind::kStripes, false,
                  "texture = \"checker\", \"grid\" or \"noise\"", given, faults);
    check_partner(of("rows"), counted && kind != TextureKind::kNoise, false,
                  "texture = \"checker\", \"grid\" or \"stripes\"", given, faults);
    check_partner(of("band_latitude"), look.mapping == BodyMapping::kBand, false, "mapping = \"band\"", given, faults);
    if (kind == TextureKind::kChecker && look.columns % 2 != 0 && section != "cylinder")
        faults.push_back({of("columns"), fmt::format("{} cells do not close round the body", look.columns),
                          "an even number for a checker"});
}

void check_sphere(const Scene& scene, double horizon, Faults& faults) {
    const double radius = scene.sphere->radius;
    if (!(radius > horizon))
        faults.push_back(
            {"sphere.radius", fmt::format("{} is not outside the horizon", radius), fmt::format("r > {}", horizon)});
    else if (!(radius < scene.camera.r))
        faults.push_back({"sphere.radius", fmt::format("the camera at r = {} is not outside of it", scene.camera.r),
                          "radius < camera.r"});
}

void check_cylinder(const Scene& scene, Faults& faults) {
    const CylinderSpec& c = *scene.cylinder;
    if (!(c.inner < c.outer)) {
        faults.push_back(
            {"cylinder.inner", fmt::format("inner = {} is not below outer = {}", c.inner, c.outer), "inner < outer"});
        return;
    }
    const Vec3 camera = camera_at(scene.camera);
    const double rho = std::hypot(camera.x, camera.y);
    if (std::abs(camera.z) <= c.height && rho >= c.inner && rho <= c.outer)
        faults.push_back({"cylinder.height", "the camera is inside of the cylinder", "a cylinder beside the camera"});
}

void check_ball(const Scene& scene, Faults& faults) {
    const BallSpec& ball = *scene.ball;
    if (!(length(ball.position) > ball.radius))
        faults.push_back({"ball.radius", "the centre lies within the ball",
                          "radius below the distance of position from the centre ([sphere] is centred)"});
    else if (!(length(camera_at(scene.camera) - ball.position) > ball.radius))
        faults.push_back({"ball.radius", "the camera is inside of the ball", "a ball beside the camera"});
}

void check_surface(const Scene& scene, const Given& given, Faults& faults) {
    const bool named = scene.surface->kind != SurfaceKind::kFormula;
    check_partner("surface.shape", !named, false, "kind = \"formula\"", given, faults);
    check_partner("surface.size", named, false, "a kind that has a name", given, faults);
    const auto shape = expr::Formula::parse(surface_shape(*scene.surface), {"x", "y", "z", "t"});
    const Vec3 at = camera_at(scene.camera);
    const double place[] = {at.x, at.y, at.z, scene.time};
    if (shape && length(at) <= scene.surface->bound && !(shape->value(place) > 0))
        faults.push_back({named ? "surface.size" : "surface.shape", fmt::format("the camera is inside: f is {} there", shape->value(place)),
                          "f above 0 at the camera"});
}

}  // namespace

std::vector<BodyFault> check_bodies(const Scene& scene, double horizon, const Given& given) {
    Faults faults;
    if (scene.sphere) check_look("sphere", scene.sphere->look, given, faults), check_sphere(scene, horizon, faults);
    if (scene.cylinder) check_look("cylinder", scene.cylinder->look, given, faults), check_cylinder(scene, faults);
    if (scene.ball) check_look("ball", scene.ball->look, given, faults), check_ball(scene, faults);
    if (scene.surface) check_look("surface", scene.surface->look, given, faults), check_surface(scene, given, faults);
    return faults;
}

}  // namespace nullscope
