// Which shaders draw a scene for less here, fragment or compute: measured.
#pragma once
#include <string>

#include "render/renderer.h"

namespace nullscope::cli {

inline constexpr const char* kFragmentStage = "fragment";
inline constexpr const char* kComputeStage = "compute";

struct StageChoice {
    std::string stage = kFragmentStage;
    std::string reason;                          // a line
    double fragment_ms = 0.0, compute_ms = 0.0;  // a frame; 0 where there was nothing to compare
};

// Of the scene that the renderer has prepared, at this size, on the display; leaves the renderer with what was chosen. Times are of the
// processor on software drivers, else of the clock on the wall: the least of three frames each, drawn in turn after one that compiles.
StageChoice choose_stage(Renderer& renderer, int width, int height);

}  // namespace nullscope::cli
