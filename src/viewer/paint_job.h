// What the window asks of the painter, and what it gets.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "scene/effects.h"
#include "scene/ray.h"
#include "scene/scene.h"
#include "shaderlib/method.h"

namespace nullscope::viewer {

struct PaintJob {
    Scene scene;
    Method method;
    bool rays = false;          // ray data instead of a picture
    double adaptation = 1.0;    // Renderer::set_adaptation
    bool coarse_first = false;  // a coarse picture may come before the whole one, if that takes long
};

// How far a job is, for people.
struct PaintProgress {
    enum class Stage { kIdle, kPreparing, kCompiling, kDrawing };
    Stage stage = Stage::kIdle;
    int rows = 0, of = 0;  // of the picture that is drawn
    friend bool operator==(const PaintProgress&, const PaintProgress&) = default;
};

// What effects cost in the frame on the screen: the picture's time, less that of the scene without the effect.
struct EffectTime {
    Effect effect;
    double ms = 0.0;
};
struct EffectTimes {
    std::vector<EffectTime> effects;
    double picture_ms = 0.0;  // of the whole
    bool complete = false;
};

struct Painting {
    PaintJob job;
    Status ready{Done{}};       // what prepare() said; else there is nothing below
    unsigned texture = 0;       // RGBA8, display-encoded; valid until the painting after it was taken
    int width = 0, height = 0;  // of the texture; of a coarse picture less than the job's
    std::optional<RayFrame> rays;
    double draw_ms = 0.0;            // the picture's, finished; compiling apart
    std::vector<std::string> notes;  // what was done to images
    int programs = 0;                // compiled for pictures until now
    double compile_ms = 0.0 /* of them all, with the driver's own at the first rows */, table_ms = 0.0, rows_ms = 0.0;

    bool coarse() const { return width < job.scene.camera.width || height < job.scene.camera.height; }
};

}  // namespace nullscope::viewer
