// What every subcommand that draws needs: a headless context and the renderer on it, in the right order of life and death.
#pragma once
#include <memory>
#include <string>

#include "base/result.h"
#include "context/context.h"
#include "render/renderer.h"

namespace nullscope::cli {

struct Session {
    std::unique_ptr<GlContext> context;
    std::unique_ptr<Renderer> renderer;  // dies first
};

// context: auto, egl, osmesa.
Result<Session> open_session(const std::string& context);

}  // namespace nullscope::cli
