// Pictures of a scene at any values of its free parameters, drawn by the shader, each pixel the mean of its rays.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "command/capture_picture.h"
#include "command/session.h"
#include "fit/free_parameters.h"

namespace nullscope::fit {

struct PaintedSize {
    int width, height;
    int samples = 4;     // rays along each side of a pixel
    bool bands = false;  // of matter seen at several frequencies, each
};

// Where to draw: asked for each picture, in the thread that draws.
using SessionSource = std::function<Result<cli::Session*>()>;
SessionSource own_session(const ContextChoice& context);  // one, opened with the first picture

class ScenePainter {
public:
    // Errors: a scene of several pictures, or with a path; no context.
    static Result<std::shared_ptr<ScenePainter>> open(SceneFamily family, SessionSource sessions);

    struct Painted {
        Scene scene;
        cli::Captured captured;  // linear light
    };
    // time: of the scene, where not its own. Cost: a picture of width x height x samples^2 rays.
    Result<Painted> paint(const std::vector<double>& values, const PaintedSize& size, std::optional<double> time = {});
    const SceneFamily& family() const { return family_; }

private:
    ScenePainter(SceneFamily family, SessionSource sessions, const Method& method);
    SceneFamily family_;
    SessionSource sessions_;
    Method method_;
    cli::DrawOptions drawing_;
};

}  // namespace nullscope::fit
