// What lies over the picture: side panel, status line, keys, messages.
#pragma once
#include <string>

#include "viewer/accuracy_section.h"
#include "viewer/effects_section.h"
#include "viewer/paint_job.h"
#include "viewer/view_state.h"
#include "viewer/window.h"

namespace nullscope::viewer {

struct FrameFacts {
    double picture_ms = 0.0;  // of the last picture, without panels
    double fps = 0.0;         // while frames follow each other; 0: drawn on demand
    double table_ms = 0.0, rows_ms = 0.0;
    PixelSize size;
    std::string renderer, version;
    bool picture = false;    // there is one
    bool coarse = false;     // it is, while a whole one is on its way
    PaintProgress progress;  // of the one that is on its way, if it takes long
};

// Over a window that has no picture yet: what is being done. Between NewFrame and Render.
void draw_first_wait(const std::string& scene, const PaintProgress& progress);

// Between ImGui's NewFrame and Render. True when the scene changed. message: shown until it is empty again.
bool draw_panels(ViewState& view, const FrameFacts& facts, const AccuracyPanel& accuracy, const EffectsPanel& effects,
                 const std::string& message, bool escape);

}  // namespace nullscope::viewer
