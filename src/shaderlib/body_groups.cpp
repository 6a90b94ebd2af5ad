#include "shaderlib/body_groups.h"

#include <fmt/format.h>

#include <algorithm>

#include "plan/body_kind.h"
#include "plan/moving.h"
#include "scene/bodies.h"
#include "scene/named_surface.h"

namespace nullscope {
namespace {

struct ShapeOf {
    BodyShapeText operator()(const SphereSpec& s) const {
        if (s.amplitude > 0.0) return {"pulse", "object/pulse.glsl", "", true};
        return {"sphere",          mino ? "object/still_sphere.glsl" : "planar/sphere.glsl", "", false, mino, true,
                s.spin_rate != 0.0};
    }
    BodyShapeText operator()(const BallSpec& b) const {
        if (b.moves()) return {"moving_ball", "object/moving_ball.glsl", "", true, true, true};
        return {"ball", "object/ball.glsl", "", false, true, true};
    }
    BodyShapeText operator()(const SurfaceSpec& s) const {
        return {"surface", "object/surface.glsl", surface_shape(s), surface_moves(s)};
    }
    template <class Shape>
    BodyShapeText operator()(const Shape&) const {  // of a kind that has one file
        return {std::string(kind), fmt::format("object/{}.glsl", kind)};
    }
    std::string_view kind;
    bool mino;
};

}  // namespace

BodyGroup group_of(const Body& body, const std::vector<ImageSource>& images, bool mino) {
    const Material& material = body.material;
    const bool image = material.texture == TextureKind::kImage;
    return {std::visit(ShapeOf{kind_of(body).key, mino}, body.shape),
            body.far,
            material.texture,
            material.mapping,
            material.texture == TextureKind::kFormula ? material.formula : "",
            image ? static_cast<int>(std::find(images.begin(), images.end(), material.source()) - images.begin()) : -1,
            material.temperature_K.has_value()};
}

std::vector<BodyGroup> groups_of(const Scene& scene, bool mino) {
    const auto images = body_images(scene);
    std::vector<BodyGroup> groups;
    std::size_t next = 0;
    for (const std::size_t i : shader_bodies(scene)) {
        BodyGroup one = group_of(scene.bodies[i], images, mino);
        if (groups.empty() || groups.back().key() != one.key()) {
            one.from = next;
            groups.push_back(std::move(one));
        }
        groups.back().to = ++next;
    }
    std::vector<std::string> formulas;  // each is a text of its own
    for (BodyGroup& group : groups) {
        if (!group.shape.formula.empty()) {
            const auto known = std::find(formulas.begin(), formulas.end(), group.shape.formula);
            if (const auto number = known - formulas.begin(); number > 0)
                group.shape.name += fmt::format("_{}", number + 1);
            if (known == formulas.end()) formulas.push_back(group.shape.formula);
        }
        const auto same = std::count_if(groups.data(), &group,
                                        [&](const BodyGroup& other) { return other.shape.name == group.shape.name; });
        group.name = same == 0 ? group.shape.name : fmt::format("{}_group_{}", group.shape.name, same + 1);
    }
    return groups;
}

}  // namespace nullscope
