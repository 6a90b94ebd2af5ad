// Panels: what lies beside the picture or over it in windows of its own. Each is a row in a file of its own; the menus, keys, the list of keys,
// --help, Escape, tours and the window follow the list in panel_rows.h.
#pragma once
#include <any>
#include <span>
#include <string>

#include "studio/flight.h"
#include "viewer/panel_parts.h"
#include "viewer/sections.h"

namespace nullscope::viewer {

// What panels draw from and change, and what of the window is left for them, in ImGui's units: what one takes of that, it takes off.
struct PanelPlace {
    ViewState& view;
    Flight& flight;
    PanelParts& parts;
    const FrameFacts& facts;
    float left, right, top, bottom;
    float gap = 0.0f;          // to be left above `bottom`
    bool escape = false;       // the key was pressed
    bool all = false;          // nothing is left for later frames
    bool changed = false;      // for panels to set: the scene is another
    bool open = true;          // of the one that is drawn: false closes it
    std::any* kept = nullptr;  // by the one that is drawn, until it is closed; nothing at first
};

struct Panel {
    enum class Where {
        kDocked,  // at the window's edges; Tab hides all of them
        kCorner,  // in the corner that these leave free
        kOver,    // over the picture and what is docked, below place.top
    };
    const char* menu;       // "View" or "Help"
    const char* name;       // in the menu
    const char* keys = "";  // as they are written: "Ctrl+E"; "": none
    int key = 0;            // GLFW's; 0: none
    bool control = false;
    const char* words;      // in the list of keys, --help and docs/viewer.md
    const char* help = "";  // tooltip
    Where where = Where::kOver;
    bool at_first = false;       // open when the viewer starts
    bool escapes = true;         // Escape closes it: of several the last of the list
    bool hides_picture = false;  // a tour that starts closes it: it lies on what the tour speaks of
    // Why it cannot be opened, or nothing; nullptr: it always can.
    std::string (*why_not)(const ViewState& view) = nullptr;
    // While it is closed, too; nullptr: never.
    bool (*needed)(const PanelPlace& place) = nullptr;
    void (*draw)(PanelPlace& place);              // between NewFrame and Render
    void (*forget)(PanelParts& parts) = nullptr;  // in frames without it: what it keeps in there
};

std::span<const Panel* const> panels();

inline bool is_open(const ViewState& view, const Panel& panel) { return view.panels.contains(panel.name); }
void set_open(ViewState& view, const Panel& panel, bool open);
bool docked(const ViewState& view);  // what Tab hides is there: panels, the menu bar, the status line
// What Escape does; false: nothing is open that it closes.
bool close_topmost_panel(ViewState& view);
void close_for_tour(ViewState& view);
// Those that are open, in the list's order: docked and in the corner, or (over) what lies over these.
void draw_panels(PanelPlace& place, bool over);

std::string spaced(const char* keys);  // as lists of keys have it: "Ctrl + E"
std::string panel_help();              // a line for each, with its keys

}  // namespace nullscope::viewer
