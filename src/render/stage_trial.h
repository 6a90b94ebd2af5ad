// Frames by fragment and by compute shaders, drawn in turn and timed, to know which take less.
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "render/renderer.h"
#include "render/stage_times.h"

namespace nullscope {

struct StageTrial {
    std::string refusal;  // why nothing is computed here, a line; else empty
    StageTimes times;     // where nothing refused
};

// draw: draws a frame of the prepared scene and says what it took, ms; nothing: it gave up, and so does this. The least of three frames of each
// counts, after one that compiles. The renderer is left with the stage that took less, or where it gave up with fragments.
std::optional<StageTrial> try_stages(Renderer& renderer, const std::function<std::optional<double>()>& draw);

// Of what the renderer has prepared: the driver that draws it, and the kind of scene as it is drawn.
std::string stage_device(const Renderer& renderer);
std::string stage_kind(const Renderer& renderer);

}  // namespace nullscope
