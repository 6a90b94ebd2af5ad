// Which shaders draw a scene for less here, fragment or compute: measured, and remembered.
#pragma once
#include <string>
#include <vector>

#include "render/renderer.h"
#include "render/stage_times.h"

namespace nullscope::cli {

struct StageChoice {
    std::string stage = kFragmentStage;
    std::string reason;  // a line
    StageTimes times{};  // 0 where there was nothing to compare
};

// Of the scene that the renderer has prepared, at this size, on the display; leaves the renderer with what was chosen. Times are of the
// processor on software drivers, else of the clock on the wall: the least of three frames each, drawn in turn after one that compiles. Kept where
// the viewer finds them.
StageChoice choose_stage(Renderer& renderer, int width, int height);

// What was measured of a scene of these effects, of each device and of both the ways that its tiles are drawn, a line each.
std::vector<std::string> remembered_stages(const Scene& scene, const EffectSet& effects);

}  // namespace nullscope::cli
