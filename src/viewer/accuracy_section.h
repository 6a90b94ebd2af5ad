// The panel's section on accuracy: what each method errs and costs, which is chosen and why, and what this frame truly errs.
#pragma once
#include <string>
#include <vector>

#include "viewer/frame_accuracy.h"
#include "viewer/method_choice.h"
#include "viewer/view_state.h"

namespace nullscope::viewer {

struct AccuracyPanel {
    const std::vector<MeasuredMethod>& measured;
    const std::string& not_measured;  // why there are no rows, or nothing
    const MethodChoice& choice;
    AccuracyFacts facts;
    double picture_ms;
};

// True when the wish for a method changed.
bool accuracy_section(ViewState& view, const AccuracyPanel& panel, bool escape);

}  // namespace nullscope::viewer
