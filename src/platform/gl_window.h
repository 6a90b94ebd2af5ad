// OpenGL contexts of a window that is never shown: what there is on Windows (WGL) in the place of EGL.
#pragma once
#include <memory>
#include <string>

namespace nullscope::platform {

class GlWindow {
public:
    virtual ~GlWindow() = default;
    virtual void* symbol(const char* name) const = 0;  // null: there is no such function
};

bool has_gl_windows();
// An OpenGL 3.3 core context, or the highest version that is compatible with it, current in this thread. Null: why says the reason.
std::unique_ptr<GlWindow> make_gl_window(std::string& why);

}  // namespace nullscope::platform
