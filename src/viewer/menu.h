// The menu bar, and the commands that menus and keys share.
#pragma once
#include <optional>

#include "viewer/view_state.h"
#include "viewer/window.h"

namespace nullscope::viewer {

enum class Command {
    kGallery,
    kSave,
    kSaveAs,
    kSavePicture,
    kReload,
    kQuit,  // file
    kUndo,
    kRedo,
    kCopyView,
    kPasteView,
    kResetCamera,  // edit
    kPanels,
    kEditor,
    kTimeline,
    kAddPlanet,
    kAddShell,
    kAddRing,
    kAddSurface,
    kAddDisc,
    kAddSpot,
    kAddSplit,
    kFall,
    kPlay,
    kRecord,
    kErrors,
    kProbe,
    kFullScreen,
    kLargerText,
    kSmallerText,  // view
    kKeys,
    kAbout,  // help
};

// Of a key that went down, with or without Ctrl.
std::optional<Command> command_of(const KeyPress& press);

// At the window's top, between NewFrame and Render; what was chosen. escape: the key was pressed, and shuts an open menu.
std::optional<Command> draw_menu(const ViewState& view, bool escape);
float menu_height();

}  // namespace nullscope::viewer
