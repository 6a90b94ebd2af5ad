// What a driver can, beyond what every context of ours has: for people, and to tell one driver from another.
#pragma once
#include <string>
#include <string_view>

namespace nullscope::gl {

struct Abilities {
    bool software = false;       // it draws by the processor
    int vector_bits = 0;         // of its processor code, as llvmpipe says it; 0: it does not say
    bool computes = false;       // gl::computes()
    bool float_targets = false;  // it draws to RGBA32F and RGBA16F
    bool timer = false;          // its clock counts
};

// Of the current context.
Abilities abilities();

// Of a renderer's name (GL_RENDERER).
bool names_software(const std::string& renderer);
int vector_bits_of(const std::string& renderer);
inline bool names_llvmpipe(std::string_view renderer) { return renderer.starts_with("llvmpipe"); }

}  // namespace nullscope::gl
