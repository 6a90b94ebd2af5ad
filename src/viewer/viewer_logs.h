// What the viewer writes of itself, for tests and for people who look for hitches.
#pragma once
#include "viewer/layout_log.h"
#include "viewer/loop_log.h"

namespace nullscope::viewer {

struct ViewerLogs {
    LoopLog turns;
    LayoutLog layout;
    int last_key = 0;  // that was pressed; GLFW's
    bool are_kept() const { return turns.is_open() || layout.is_open(); }
};

}  // namespace nullscope::viewer
