// All panels, in the menus' order; drawn in this order, closed by Escape in the other.
#pragma once
#include "viewer/panel.h"

namespace nullscope::viewer {

extern const Panel kSidePanel, kTimelinePanel, kProbePanel, kBookmarksPanel, kHistogramPanel, kLoopPanel,
    kTelescopePanel, kChangePanel, kKeysPanel, kEditorPanel, kAboutPanel, kToursPanel;

inline constexpr const Panel* kPanelRows[] = {
    &kSidePanel,       //
    &kTimelinePanel,   //
    &kProbePanel,      //
    &kBookmarksPanel,  // beside the probe
    &kHistogramPanel,  //
    &kLoopPanel,       // beside the histogram
    &kTelescopePanel,  // beside the histogram
    &kChangePanel,     //
    &kKeysPanel,       //
    &kEditorPanel,     // above the strips
    &kAboutPanel,      //
    &kToursPanel,      //
};

}  // namespace nullscope::viewer
