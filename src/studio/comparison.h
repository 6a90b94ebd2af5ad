// Two settings of one view, side by side: A, which is edited, left of a divider, and B, as it was stored, right of it.
#pragma once
#include <string>
#include <utility>

#include "studio/paint_job.h"
#include "studio/view_state.h"

namespace nullscope::viewer {

// What side B shows: its settings and exposure, seen by the view's camera at the view's time. The view has a side B.
Scene drawn_side_b(const ViewState& view);

// The settings of both sides change places, exposures too; camera, path and time stay. Nothing without a side B.
void swap_sides(ViewState& view);
// Between two values of ViewState::sides.
inline bool sides_swapped(int before, int after) { return (before ^ after) == 1; }

// What differs between both sides' jobs, in words for either: spacetimes and light, or else at most two keys of the scene, or else the
// methods. Camera, path and time are the same. Where nothing differs: "A" and "B" alone. Cost: 0.1 ms.
std::pair<std::string, std::string> side_words(const PaintJob& a, const PaintJob& b);

}  // namespace nullscope::viewer
