#include "viewer/clock_overlay.h"
#include "viewer/critical_overlay.h"
#include "viewer/embedding_panel.h"
#include "viewer/guides_overlay.h"
#include "viewer/overlay.h"

namespace nullscope::viewer {

// In the menu's order.
std::span<const Overlay* const> overlays() {
    static constexpr const Overlay* kOverlays[] = {&kCriticalOverlay, &kEmbeddingOverlay, &kClockOverlay,
                                                   &kGuidesOverlay};
    return kOverlays;
}

void toggle(ViewState& view, const Overlay& overlay) {
    if (!view.overlays.erase(overlay.name)) view.overlays.insert(overlay.name);
}

void draw_overlays(Overlay::Where where, OverlayPlace& place) {
    for (const Overlay* overlay : overlays())
        if (overlay->where == where && shows(place.view, *overlay)) overlay->draw(place);
}

}  // namespace nullscope::viewer
