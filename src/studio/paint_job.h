// What the window asks of the painter.
#pragma once
#include <memory>

#include "scene/scene.h"
#include "shaderlib/method.h"

namespace nullscope::viewer {

// What traces pictures, which are the same: fragment or compute shaders; kAuto: what took less when this kind of scene was measured, on software
// drivers, where compute gains nothing, fragments; kMeasured: the same, measured on those too.
enum class StageWish { kAuto, kMeasured, kFragment, kCompute };

struct PaintJob {
    Scene scene;
    Method method;
    bool rays = false;          // ray data instead of a picture
    double adaptation = 1.0;    // Renderer::set_adaptation
    bool coarse_first = false;  // a coarse picture may come before the whole one, if that takes long
    std::shared_ptr<const PaintJob> side_b =
        nullptr;         // a second picture of the same size, by the same camera; has none itself
    bool light = false;  // and the light of a few pixels beside it (viewer/small_light.h)
    StageWish stage = StageWish::kAuto;
};

}  // namespace nullscope::viewer
