// The files of shaders/, part of the binary: generated at build time by embed.cmake.
#pragma once
#include <span>
#include <string_view>

namespace nullscope {

struct EmbeddedShader {
    std::string_view path, text;
};
std::span<const EmbeddedShader> embedded_shaders();

}  // namespace nullscope
