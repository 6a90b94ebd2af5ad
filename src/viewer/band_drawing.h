// A picture drawn in bands of rows, so that the window answers and a newer job is not kept waiting (studio/bands.h).
#pragma once
#include <functional>
#include <optional>

#include "gl/gl.h"
#include "render/renderer.h"

namespace nullscope::viewer {

// How far a job is, for people.
struct PaintProgress {
    enum class Stage { kIdle, kPreparing, kCompiling, kDrawing };
    Stage stage = Stage::kIdle;
    int rows = 0, of = 0;  // of the picture that is drawn
    friend bool operator==(const PaintProgress&, const PaintProgress&) = default;
};

// What a picture is told and asked while it is drawn.
struct DrawWatch {
    std::function<bool()> give_up;  // asked between bands
    std::function<void(const PaintProgress&)> tell;
};

struct DrawTimes {
    double draw_ms = 0.0, compile_ms = 0.0;
};

// Draws what is prepared; nothing if it was given up. ray_ms: what a ray takes in the dearest row of the last picture, by which this
// one is cut into bands, then of this one; 0: not known.
std::optional<DrawTimes> draw_in_bands(Renderer& renderer, const gl::Target& target, double& ray_ms,
                                       const DrawWatch& watch);

}  // namespace nullscope::viewer
