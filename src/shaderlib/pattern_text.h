// The text of textures by formulas and patterns: what covers bodies, the disc and the sky.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace nullscope {

std::string replaced(std::string text, std::string_view what, std::string_view with);

// A formula's statements, which set `value`; `otherwise` where it is none.
std::string statements(const std::string& text, const std::vector<std::string>& variables, const char* otherwise);

// The template of shaders/object/pattern.glsl for what is covered. mapping: the symbol to define; image: the number of its own.
std::string pattern_text(const std::string& name, const Material& material, const char* mapping, bool solid, int image);

// Those of a scene's disc and sky.
std::string materials_of(const Scene& scene);

}  // namespace nullscope
