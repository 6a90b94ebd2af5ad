// The critical curve as a line over the picture in the window.
#pragma once
#include "viewer/overlay.h"

namespace nullscope::viewer {

inline constexpr unsigned kCriticalColour = 0xff96ff78u;  // ImGui's order: alpha, blue, green, red

// Of the scene on the screen, either half of a split one. Under a millisecond.
extern const Overlay kCriticalOverlay;

}  // namespace nullscope::viewer
