// The menu bar, and the commands that menus and keys share.
#pragma once
#include <optional>
#include <string>

#include "studio/view_state.h"
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
    kCriticalCurve,
    kPotential,
    kBookmark,
    kBookmarks,
    kLightTheme,
    kClockOverlay,
    kOrders,
    kEmbedding,
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
};

// Of a key that went down, with or without Ctrl.
std::optional<Command> command_of(const KeyPress& press);

// Why it cannot be done here, or nothing.
std::string why_not(Command command, const ViewState& view);

// At the window's top, between NewFrame and Render; what was chosen. escape: the key was pressed, and shuts an open menu.
std::optional<Command> draw_menu(const ViewState& view, bool escape);
float menu_height();

}  // namespace nullscope::viewer
