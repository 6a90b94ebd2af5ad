#include "platform/gl_window.h"

namespace nullscope::platform {

bool has_gl_windows() { return false; }

std::unique_ptr<GlWindow> make_gl_window(std::string& why) {
    why = "there is none on this system";
    return nullptr;
}

}  // namespace nullscope::platform
