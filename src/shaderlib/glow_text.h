// Shader text of bodies that shine by their heat.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace nullscope {

// Of the scene's vectors (shaders/shared/objects.glsl): the first of those of bodies with a temperature, in the shader's order, and the one
// after their last.
std::size_t glow_from(const Scene& scene);
std::size_t glow_to(const Scene& scene);
// Where the turn of the sphere that is seen stands, of which there may be none, and its caps.
std::size_t turn_from(const Scene& scene);
std::size_t caps_from(const Scene& scene);
std::size_t caps_to(const Scene& scene);
std::string turn_defines(const Scene& scene);  // names of these places
bool sphere_turns(const Scene& scene);
bool has_caps(const Scene& scene);

// A group of bodies that share their text.
struct GlowGroup {
    std::string name, shape;  // of their functions; shape: of those of their motion
    bool moves, capped;       // capped: with caps
    std::size_t from, to;     // in the shader's order
};

// Of groups of such bodies. shift: NAME_g of each, and solid_g, 0 for other bodies. light: NAME_glow.
struct GlowText {
    std::string shift, light;
};
GlowText glow_text(const Scene& scene, const std::vector<GlowGroup>& groups);

// Of each such body (shaders/object/glow.glsl).
inline constexpr std::size_t kGlowVectors = 2;

}  // namespace nullscope
