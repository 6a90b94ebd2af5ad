#include "gl/abilities.h"

#include <glad/gl.h>

#include <cstdio>
#include <string_view>

#include "gl/compute.h"
#include "gl/gl.h"

namespace nullscope::gl {
namespace {

bool draws_to(Format format) {
    try {
        make_target(4, 4, format);
        return true;
    } catch (const GlError&) {
        return false;
    }
}

}  // namespace

bool names_software(const std::string& renderer) {
    for (const std::string_view name :
         {"llvmpipe", "softpipe", "swrast", "lavapipe", "SwiftShader", "Software Rasterizer"})
        if (renderer.find(name) != std::string::npos) return true;
    return false;
}

int vector_bits_of(const std::string& renderer) {
    const std::size_t end = renderer.find(" bits");
    if (end == std::string::npos) return 0;
    const std::size_t before = renderer.find_last_not_of("0123456789", end - 1);
    int bits = 0;
    return std::sscanf(renderer.c_str() + (before + 1), "%d", &bits) == 1 ? bits : 0;
}

Abilities abilities() {
    const std::string renderer = info().renderer;
    GLint counter_bits = 0;
    glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &counter_bits);
    return {names_software(renderer), vector_bits_of(renderer), computes(),
            draws_to(Format::kRgba16F) && draws_to(Format::kRgba32F), counter_bits > 0};
}

}  // namespace nullscope::gl
