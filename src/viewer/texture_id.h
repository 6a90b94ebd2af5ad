// A texture as Dear ImGui draws it.
#pragma once
#include <imgui.h>

#include <cstdint>

#include "gl/gl.h"

namespace nullscope::viewer {

inline ImTextureID id_of(const gl::Texture& texture) {
    // NOLINTNEXTLINE: pointer or integer by version.
    return (ImTextureID)(static_cast<std::intptr_t>(texture.id()));
}

}  // namespace nullscope::viewer
