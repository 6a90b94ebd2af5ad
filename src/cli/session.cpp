#include "cli/session.h"

#include "gl/gl.h"

namespace nullscope::cli {

Result<Session> open_session(const std::string& context) {
    auto made = make_headless_context(context);
    if (!made) return made.error();
    Session session;
    session.context = std::move(*made);
    gl::load_functions(
        [](const char* name, void* user) { return static_cast<GlContext*>(user)->get_proc_address(name); },
        session.context.get());
    session.renderer = std::make_unique<Renderer>();
    return session;
}

}  // namespace nullscope::cli
