// Lines for framing a picture: thirds, the middle, the part that every screen shows.
#pragma once
#include "viewer/overlay.h"

namespace nullscope::viewer {

extern const Overlay kGuidesOverlay;

}  // namespace nullscope::viewer
