// The menu bar, and the commands that menus and keys share.
#pragma once
#include <optional>
#include <string>

#include "studio/view_state.h"
#include "viewer/overlay.h"
#include "viewer/panel.h"
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
    kErrors,
    kFullScreen,
    kLargerText,
    kSmallerText,
    kPotential,
    kBookmark,
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
    // tours
    kTourNext,
    kTourBack,
    kPanel,    // viewer/panel.h
    kOverlay,  // viewer/overlay.h
};

// A command, or the switch of an overlay or a panel.
struct Action {
    Command command;
    const Overlay* overlay = nullptr;
    const Panel* panel = nullptr;
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
