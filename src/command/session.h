// What every subcommand that draws needs: a headless context and the renderer on it, in the right order of life and death.
#pragma once
#include <memory>

#include "base/result.h"
#include "context/context.h"
#include "gl/driver_death.h"
#include "gl/gl.h"
#include "render/renderer.h"

namespace nullscope::cli {

using gl::name_driver_at_death;  // for main()

struct Session {
    std::unique_ptr<GlContext> context;
    std::unique_ptr<Renderer> renderer;  // dies first
};

inline Result<Session> open_session(const ContextChoice& context) {
    TRY(made, make_headless_context(context));
    Session session;
    session.context = std::move(*made);
    gl::load_functions(
        [](const char* name, void* user) { return static_cast<GlContext*>(user)->get_proc_address(name); },
        session.context.get());
    session.renderer = std::make_unique<Renderer>();
    return session;
}

}  // namespace nullscope::cli
