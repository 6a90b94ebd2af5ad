// An OpenGL 3.3 core context without a window: EGL (a device or Mesa's surfaceless platform) or OSMesa, both opened at run time.
// Only one is current in a thread at a time; drawing goes to framebuffer objects.
#pragma once
#include <memory>
#include <string>

#include "base/result.h"

namespace nullscope {

using GlProc = void (*)();

class GlContext {
public:
    virtual ~GlContext() = default;
    virtual GlProc get_proc_address(const char* name) const = 0;
    virtual std::string kind() const = 0;  // "egl", "osmesa"
};

// Errors: the library is not installed, or no context of version 3.3 core can be had; the sentence says which and what to do.
Result<std::unique_ptr<GlContext>> make_egl_context();
Result<std::unique_ptr<GlContext>> make_osmesa_context();

// "egl", "osmesa" or "auto" (EGL, then OSMesa). The context is current on return.
Result<std::unique_ptr<GlContext>> make_headless_context(const std::string& kind);

}  // namespace nullscope
