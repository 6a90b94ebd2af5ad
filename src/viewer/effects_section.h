// The panel's section on effects: what the scene calls for and why, what each costs in this frame, and a switch for each.
#pragma once
#include "viewer/painter.h"
#include "viewer/view_state.h"

namespace nullscope::viewer {

struct EffectsPanel {
    const EffectTimes& times;
    const Scene& drawn;  // what the times are of
    bool background;     // programs are compiled while the last picture stays
    int programs;        // compiled for pictures until now
    double compile_ms;   // all of them together
};

// True when an effect was switched.
bool effects_section(ViewState& view, const EffectsPanel& panel);

}  // namespace nullscope::viewer
