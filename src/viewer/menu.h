// The menu bar, and the commands that menus and keys share.
#pragma once
#include <optional>
#include <string>

#include "studio/view_state.h"
#include "viewer/overlay.h"
#include "viewer/window.h"

namespace nullscope::viewer {

enum class Command {
    // file
    kGallery,
    kSave,
    kSaveAs,
    kSavePicture,
    kReload,
    kQuit,
    // edit
    kUndo,
    kRedo,
    kCopyView,
    kPasteView,
    kResetCamera,
    // view
    kPanels,
    kEditor,
    kTimeline,
    kErrors,
    kProbe,
    kFullScreen,
    kLargerText,
    kSmallerText,
    kPotential,
    kBookmark,
    kBookmarks,
    kLightTheme,
    kOrders,
    kCompare,
    kSwapSides,
    kNavigate,
    // add
    kAddPlanet,
    kAddDisc,
    kAddSpot,
    kAddRing,
    kAddSurface,
    kAddShell,
    kAddSplit,
    // path
    kFall,
    kPlay,
    kRecord,
    // help
    kKeys,
    kAbout,
    kTours,
    kTourNext,
    kTourBack,
    kOverlay,  // viewer/overlay.h
};

// A command, or an overlay's switch.
struct Action {
    Command command;
    const Overlay* overlay = nullptr;
    friend bool operator==(const Action& action, Command command) { return action.command == command; }
};

// Of a key that went down, with or without Ctrl.
std::optional<Action> action_of(const KeyPress& press);

// Why it cannot be done here, or nothing.
std::string why_not(const Action& action, const ViewState& view);

// At the window's top, between NewFrame and Render; what was chosen. escape: the key was pressed, and shuts an open menu.
std::optional<Action> draw_menu(const ViewState& view, bool escape);
float menu_height();

}  // namespace nullscope::viewer
