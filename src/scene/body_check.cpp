#include "scene/body_check.h"

#include <fmt/format.h>

#include <cmath>

#include "expr/formula.h"
#include "scene/named_surface.h"

namespace nullscope {
namespace {

using Given = std::function<bool(const std::string&)>;
using Faults = std::vector<BodyFault>;

// Of wormholes: on its own side.
Vec3 camera_at(const CameraSpec& camera) {
    const double s = std::sin(camera.theta);
    return std::fabs(camera.r) * Vec3{s * std::cos(camera.phi), s * std::sin(camera.phi), std::cos(camera.theta)};
}

bool camera_is_there(const CameraSpec& camera, bool far) { return (camera.r < 0.0) == far; }

// A key that another key's value calls for, or rules out.
void check_partner(const std::string& key, bool wanted, bool needed, const std::string& partner, const Given& given,
                   Faults& faults) {
    if (wanted && needed && !given(key)) faults.push_back({key, fmt::format("missing, but {}", partner), "a value"});
    if (!wanted && given(key)) faults.push_back({key, "has no meaning here", fmt::format("with {} only", partner)});
}

// word: the key that chooses the texture.
void check_pattern(const std::string& section, const std::string& word, const BodyLook& look, const Given& given,
                   Faults& faults) {
    const auto of = [&](const char* key) { return fmt::format("{}.{}", section, key); };
    const TextureKind kind = look.texture;
    const bool plain = kind == TextureKind::kPlain, image = kind == TextureKind::kImage,
               formula = kind == TextureKind::kFormula;
    check_partner(of("formula"), formula, true, word + " = \"formula\"", given, faults);
    const bool counted = !plain && !image && !formula;
    check_partner(of("columns"), counted && kind != TextureKind::kStripes, false,
                  word + " = \"checker\", \"grid\" or \"noise\"", given, faults);
    check_partner(of("rows"), counted && kind != TextureKind::kNoise, false,
                  word + " = \"checker\", \"grid\" or \"stripes\"", given, faults);
    if (kind == TextureKind::kChecker && look.columns % 2 != 0 && section != "cylinder")
        faults.push_back({of("columns"), fmt::format("{} cells do not close round about", look.columns),
                          "an even number for a checker"});
}

void check_look(const std::string& section, const BodyLook& look, const Given& given, Faults& faults) {
    check_partner(section + ".image", look.texture == TextureKind::kImage, true, "texture = \"image\"", given, faults);
    check_pattern(section, "texture", look, given, faults);
    check_partner(section + ".band_latitude", look.mapping == BodyMapping::kBand, false, "mapping = \"band\"", given,
                  faults);
}

void check_disc_look(const BodyLook& look, const Given& given, Faults& faults) {
    const bool image = look.texture == TextureKind::kImage;
    check_partner("disc.image", image, false, "texture = \"image\"", given, faults);
    check_pattern("disc", "texture", look, given, faults);
    check_partner("disc.colour", !image, false, "a texture that is no image", given, faults);
    check_partner("disc.second_colour", !image && look.texture != TextureKind::kPlain, false,
                  "a texture of two colours", given, faults);
}

void check_sky_look(const SkySpec& sky, const Given& given, Faults& faults) {
    check_pattern("sky", "kind", sky_look(sky), given, faults);
    check_partner("sky.colour", has_look(sky.kind), false, "kind = \"plain\" or a pattern", given, faults);
    check_partner("sky.second_colour", has_look(sky.kind) && sky.kind != SkyKind::kPlain, false,
                  "a kind of two colours", given, faults);
}

void check_sphere(const Scene& scene, double horizon, Faults& faults) {
    const double least = scene.sphere->radius * (1 - scene.sphere->swing),
                 most = scene.sphere->radius * (1 + scene.sphere->swing);
    if (!(least > horizon))
        faults.push_back(
            {"sphere.radius", fmt::format("{} is not outside the horizon", least), fmt::format("r > {}", horizon)});
    else if (!(most < scene.camera.r))
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
    if (camera_is_there(scene.camera, c.far) && std::abs(camera.z) <= c.height && rho >= c.inner && rho <= c.outer)
        faults.push_back({"cylinder.height", "the camera is inside of the cylinder", "a cylinder beside the camera"});
}

void check_ball(const Scene& scene, Faults& faults) {
    const BallSpec& ball = *scene.ball;
    if (ball.motion == BallMotion::kPath) return;
    if (!(length(ball.position) > ball.radius))
        faults.push_back({"ball.radius", "the centre lies within the ball",
                          "radius below the distance of position from the centre ([sphere] is centred)"});
    else if (ball.motion == BallMotion::kStill && camera_is_there(scene.camera, ball.far) &&
             !(length(camera_at(scene.camera) - ball.position) > ball.radius))
        faults.push_back({"ball.radius", "the camera is inside of the ball", "a ball beside the camera"});
}

void check_surface(const Scene& scene, const Given& given, Faults& faults) {
    const bool named = scene.surface->kind != SurfaceKind::kFormula;
    check_partner("surface.shape", !named, false, "kind = \"formula\"", given, faults);
    check_partner("surface.size", named, false, "a kind that has a name", given, faults);
    const auto shape = expr::Formula::parse(surface_shape(*scene.surface), {"x", "y", "z", "t"});
    const Vec3 at = camera_at(scene.camera);
    const double place[] = {at.x, at.y, at.z, scene.time};
    if (shape && camera_is_there(scene.camera, scene.surface->far) && length(at) <= scene.surface->bound &&
        !(shape->value(place) > 0))
        faults.push_back({named ? "surface.size" : "surface.shape",
                          fmt::format("the camera is inside: f is {} there", shape->value(place)),
                          "f above 0 at the camera"});
}

}  // namespace

std::vector<BodyFault> check_bodies(const Scene& scene, double horizon, const Given& given) {
    Faults faults;
    check_sky_look(scene.sky, given, faults);
    if (scene.disc) check_disc_look(scene.disc->look, given, faults);
    if (scene.sphere) check_look("sphere", scene.sphere->look, given, faults), check_sphere(scene, horizon, faults);
    if (scene.cylinder) check_look("cylinder", scene.cylinder->look, given, faults), check_cylinder(scene, faults);
    if (scene.ball) check_look("ball", scene.ball->look, given, faults), check_ball(scene, faults);
    if (scene.surface) check_look("surface", scene.surface->look, given, faults), check_surface(scene, given, faults);
    return faults;
}

}  // namespace nullscope
