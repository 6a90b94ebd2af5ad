// Overlays: what explains the picture, drawn over it. Each is a row in a file of its own; the menu View, keys, the list of keys, tours and
// the window follow the list in overlays.cpp.
#pragma once
#include <span>
#include <string>

#include "studio/view_state.h"
#include "viewer/probe.h"

namespace nullscope::viewer {

// Where an overlay may draw, in ImGui's units: kPicture in all of the window, clipped to its side; others in the part of the picture that panels
// leave free. What it takes of that, it takes off.
struct OverlayPlace {
    const ViewState& view;
    const Scene& scene;  // of the picture on the screen: of kPicture, of the side that is drawn
    const Probe& probe;
    float left, right, top, bottom;
};

struct Overlay {
    enum class Where {
        kPicture,     // over each side of the picture, behind the panels
        kTopLeft,     // in a row at the top: the next begins at place.left
        kBottomLeft,  // one above the other: the next ends at place.bottom
    };
    const char* name;       // in the menu
    const char* keys;       // as they are written; "": none
    int key;                // GLFW's; 0: none
    const char* key_words;  // in the list of keys, if it has one
    const char* help;       // tooltip
    // Why there is nothing to show, or nothing; nullptr: there always is.
    std::string (*why_not)(const ViewState& view);
    Where where;
    void (*draw)(OverlayPlace& place);  // between NewFrame and Render
};

std::span<const Overlay* const> overlays();

inline bool shows(const ViewState& view, const Overlay& overlay) { return view.overlays.contains(overlay.name); }
// Switches it on or off.
void toggle(ViewState& view, const Overlay& overlay);
// Those that are on and belong there.
void draw_overlays(Overlay::Where where, OverlayPlace& place);

}  // namespace nullscope::viewer
