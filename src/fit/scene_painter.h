// Pictures of a scene at any values of its free parameters, drawn by the shader, each pixel the mean of its rays.
#pragma once
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
    int samples = 4;  // rays along each side of a pixel
};

class ScenePainter {
public:
    // context: of OpenGL. Errors: no context; a scene of several pictures.
    static Result<std::shared_ptr<ScenePainter>> open(SceneFamily family, const ContextChoice& context);

    struct Painted {
        Scene scene;
        cli::Captured captured;  // linear light
    };
    // time: of the scene, where not its own. Cost: a picture of width x height x samples^2 rays.
    Result<Painted> paint(const std::vector<double>& values, const PaintedSize& size, std::optional<double> time = {});
    const SceneFamily& family() const { return family_; }

private:
    ScenePainter(SceneFamily family, cli::Session session);
    SceneFamily family_;
    cli::Session session_;
    cli::DrawOptions drawing_;
};

}  // namespace nullscope::fit
