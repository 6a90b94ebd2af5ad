// A solid given by a formula, or one that is known by name.
#include <fmt/format.h>

#include "expr/formula.h"
#include "plan/body_kind.h"
#include "plan/moving.h"
#include "scene/named_surface.h"

namespace nullscope {
namespace {

const SurfaceSpec& surface_of(const Body& body) { return std::get<SurfaceSpec>(body.shape); }

bool has_formula_texture(const Scene& s) { return last_body<SurfaceSpec>(s).kind == SurfaceKind::kFormula; }

std::vector<SceneKey> surface_keys() {
    return {
        {"surface", "kind", KeyType::kChoice, "", "formula", kNoRange,
         "formula torus ellipsoid cube octahedron heart gyroid clebsch",
         "Which solid: given by the formula, or built in.", [](auto& s) { return &last_body<SurfaceSpec>(s).kind; }},
        {"surface", "size", KeyType::kNumber, "r_s", "6", kPositive, "",
         "Unit of length of a built-in surface; needs a kind other than \"formula\".",
         [](auto& s) { return &last_body<SurfaceSpec>(s).size; },
         [](const Scene& s) { return !has_formula_texture(s); }, "a kind that has a name"},
        {"surface", "shape", KeyType::kFormula, "", "(length(x, y) - 6)^2 + z^2 - 2", kNoRange, "x y z t",
         "f(x, y, z, t), negative inside the solid; t is time. The camera must be outside. Needs kind = \"formula\".",
         [](auto& s) { return &last_body<SurfaceSpec>(s).shape; }, has_formula_texture, "kind = \"formula\""},
        {"surface", "bound", KeyType::kNumber, "r_s", "10", kPositive, "",
         "Bounding radius: the solid is cut off beyond it.", [](auto& s) { return &last_body<SurfaceSpec>(s).bound; }},
        {"surface", "steps", KeyType::kWhole, "", "64", closed(16.0, 256.0), "",
         "March steps across the bounding sphere; parts thinner than a step may be missed.",
         [](auto& s) { return &last_body<SurfaceSpec>(s).steps; }},
    };
}

void check_surface(const Body& body, const BodyCheck& at) {
    const SurfaceSpec& surface = surface_of(body);
    const bool named = surface.kind != SurfaceKind::kFormula;
    const auto shape = expr::Formula::parse(surface_shape(surface), {"x", "y", "z", "t"});
    const Vec3 camera = at.camera();
    const double place[] = {camera.x, camera.y, camera.z, at.scene.time};
    if (shape && at.camera_is_there(body.far) && length(camera) <= surface.bound && !(shape->value(place) > 0))
        at.report({named ? "size" : "shape", fmt::format("the camera is inside: f is {} there", shape->value(place)),
                   "f above 0 at the camera"});
}

}  // namespace

const BodyKind kSurfaceKind{
    .key = SurfaceSpec::kName,
    .effect = {Effect::kSurface, "surface", "EFFECT_SURFACE", "A solid given by a formula ends rays.",
               "there is a [surface]", "steps along the ray, each with one fetch and the formula"},
    .make = [] { return Body{SurfaceSpec{}}; },
    .keys = surface_keys,
    .check = check_surface,
    .words =
        [](const Body& body) {
            const SurfaceSpec& s = surface_of(body);
            return fmt::format("{} within {}",
                               s.kind == SurfaceKind::kFormula
                                   ? s.shape
                                   : std::string(kNamedSurfaces[static_cast<std::size_t>(s.kind)].key),
                               s.bound);
        },
    .extent =
        [](const Body& body) {
            return BodyExtent{0.0, surface_of(body).bound, 2 * surface_of(body).bound / surface_of(body).steps};
        },
    .size = [](const Body& body) { return surface_of(body).bound; },
    .moves = [](const Body& body) { return surface_moves(surface_of(body)) ? "shape" : nullptr; },
};

}  // namespace nullscope
