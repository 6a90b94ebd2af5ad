#include <fmt/format.h>

#include "context/context.h"

namespace nullscope {

Result<std::unique_ptr<GlContext>> make_headless_context(const std::string& kind) {
    if (kind == "egl") return make_egl_context();
    if (kind == "osmesa") return make_osmesa_context();
    if (kind != "auto") return bad_input(fmt::format("context \"{}\" is not known", kind), "auto, egl, osmesa");
    auto egl = make_egl_context();
    if (egl) return egl;
    auto osmesa = make_osmesa_context();
    if (osmesa) return osmesa;
    return failed("no OpenGL 3.3 context: " + egl.error().message() + "; " + osmesa.error().message());
}

}  // namespace nullscope
