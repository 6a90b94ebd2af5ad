// Controls of lengths in the unit that is chosen for numbers; what they change is in r_s.
#pragma once
#include "scene/scene_key.h"
#include "studio/number_words.h"

namespace nullscope::viewer {

// As type_number and drag_number (widgets.h). length, low, high, speed, allowed: r_s, or a wormhole's own unit.
bool type_length(const char* name, double& length, double low, double high, const NumberStyle& style, const char* help);
bool drag_length(const char* name, double& length, double speed, const KeyRange& allowed, double low, double high,
                 const NumberStyle& style, const char* help);

}  // namespace nullscope::viewer
