// Bodies of a scene that share all of their shader text.
#pragma once
#include <string>
#include <tuple>
#include <vector>

#include "scene/scene.h"
#include "shaderlib/body_text.h"

namespace nullscope {

// How a body's shape is known to the shader.
struct BodyShapeText {
    std::string name;  // of its functions: NAME_value, NAME_room, NAME_normal, NAME_middle, NAME_size
    std::string file;  // that defines them
    std::string formula{};
    bool moves = false, marched = true, round = false, turns = false;
    auto operator<=>(const BodyShapeText&) const = default;  // NOLINT(modernize-use-nullptr): no pointer
};

// Bodies that share all their text.
struct BodyGroup {
    BodyShapeText shape;
    bool far;
    TextureKind texture;
    BodyMapping mapping;
    std::string formula;
    int image;
    bool glows;
    std::string name{};            // of its light
    std::size_t from = 0, to = 0;  // in the shader's order
    bool is_list() const { return to - from > 1; }
    bool is_still() const { return !shape.moves && !shape.turns; }
    auto key() const { return std::tie(shape.marched, shape, far, texture, mapping, formula, image, glows); }
};

// images: body_images of the scene. mino: about a rotating hole (planar rays meet still spheres in a closed form).
BodyGroup group_of(const Body& body, const std::vector<ImageSource>& images, bool mino);
// In the shader's order.
std::vector<BodyGroup> groups_of(const Scene& scene, bool mino);

}  // namespace nullscope
