// The panel's rows of what heats a thermal disc.
#pragma once
#include "scene/scene.h"
#include "studio/number_words.h"

namespace nullscope::viewer {

// horizon: r_s, 0 where there is none. True when something changed.
bool heat_rows(DiscSpec& disc, double horizon, const NumberStyle& style, bool escape);

}  // namespace nullscope::viewer
