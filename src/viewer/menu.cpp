#include "viewer/menu.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "viewer/order_overlay.h"
#include "viewer/overlay.h"
#include "viewer/potential_plot.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr const char* kNavigateHelp =
    "Arrow keys go through the panels and Enter presses what they are on; Ctrl+Tab goes to the next panel, Escape back "
    "to the picture.";

struct Entry {
    Command command;
    std::string_view menu;
    const char* name;
    const char* keys;  // as they are written
    int key;           // GLFW's; 0: none
    bool control, shift;
    bool ViewState::*shown;     // what it switches, or nullptr
    bool begins_group = false;  // a line is above it
};

constexpr std::array kEntries = {
    Entry{Command::kGallery, "File", "Open...", "Ctrl+O", GLFW_KEY_O, true, false, nullptr},
    Entry{Command::kSave, "File", "Save scene", "Ctrl+S", GLFW_KEY_S, true, false, nullptr, true},
    Entry{Command::kSaveAs, "File", "Save scene as...", "Ctrl+Shift+S", GLFW_KEY_S, true, true, nullptr},
    Entry{Command::kSavePicture, "File", "Save picture", "F12", GLFW_KEY_F12, false, false, nullptr},
    Entry{Command::kReload, "File", "Reload", "F5", GLFW_KEY_F5, false, false, nullptr},
    Entry{Command::kQuit, "File", "Quit", "Ctrl+Q", GLFW_KEY_Q, true, false, nullptr, true},
    Entry{Command::kUndo, "Edit", "Undo", "Ctrl+Z", GLFW_KEY_Z, true, false, nullptr},
    Entry{Command::kRedo, "Edit", "Redo", "Ctrl+Shift+Z", GLFW_KEY_Z, true, true, nullptr},
    Entry{Command::kCopyView, "Edit", "Copy view", "Ctrl+C", GLFW_KEY_C, true, false, nullptr, true},
    Entry{Command::kPasteView, "Edit", "Paste view", "Ctrl+V", GLFW_KEY_V, true, false, nullptr},
    Entry{Command::kResetCamera, "Edit", "Reset camera", "R", GLFW_KEY_R, false, false, nullptr, true},
    Entry{Command::kPanel, "View", "", "", 0, false, false, nullptr},  // all of this menu
    Entry{Command::kNavigate, "View", "Panels by keyboard", "Ctrl+Tab", GLFW_KEY_TAB, true, false, nullptr},
    Entry{Command::kErrors, "View", "Errors of pixels", "H", GLFW_KEY_H, false, false, &ViewState::show_errors, true},
    Entry{Command::kPotential, "View", "Effective potential", "", 0, false, false, &ViewState::show_potential},
    Entry{Command::kOrders, "View", "Image orders", "O", GLFW_KEY_O, false, false, &ViewState::show_orders},
    Entry{Command::kOverlay, "View", "", "", 0, false, false, nullptr},  // all of them
    Entry{Command::kCompare, "View", "Compare with this", "X", GLFW_KEY_X, false, false, nullptr, true},
    Entry{Command::kSwapSides, "View", "Swap sides A and B", "Shift+X", GLFW_KEY_X, false, true, nullptr},
    Entry{Command::kBookmark, "View", "Bookmark this view", "Ctrl+B", GLFW_KEY_B, true, false, nullptr, true},
    Entry{Command::kFullScreen, "View", "Full screen", "F11", GLFW_KEY_F11, false, false, nullptr, true},
    Entry{Command::kLargerText, "View", "Larger text", "Ctrl++", GLFW_KEY_EQUAL, true, false, nullptr},
    Entry{Command::kSmallerText, "View", "Smaller text", "Ctrl+-", GLFW_KEY_MINUS, true, false, nullptr},
    Entry{Command::kLightTheme, "View", "Light theme", "", 0, false, false, &ViewState::light_theme},
    Entry{Command::kAddPlanet, "Add", "Planet (ball)", "", 0, false, false, nullptr},
    Entry{Command::kAddDisc, "Add", "Disc", "", 0, false, false, nullptr},
    Entry{Command::kAddSpot, "Add", "Hot spot in the disc", "", 0, false, false, nullptr},
    Entry{Command::kAddRing, "Add", "Ring (cylinder)", "", 0, false, false, nullptr},
    Entry{Command::kAddSurface, "Add", "Surface by formula", "", 0, false, false, nullptr},
    Entry{Command::kAddShell, "Add", "Shell about the hole (sphere)", "", 0, false, false, nullptr},
    Entry{Command::kAddSplit, "Add", "Split screen", "", 0, false, false, nullptr},
    Entry{Command::kFall, "Path", "Fall freely", "F", GLFW_KEY_F, false, false, nullptr},
    Entry{Command::kPlay, "Path", "Play, pause", "L", GLFW_KEY_L, false, false, nullptr},
    Entry{Command::kRecord, "Path", "Record, stop", "F9", GLFW_KEY_F9, false, false, nullptr},
    Entry{Command::kPanel, "Help", "", "", 0, false, false, nullptr},
    // keys alone, in no menu
    Entry{Command::kTourNext, "", "Next step", "Page Down", GLFW_KEY_PAGE_DOWN, false, false, nullptr},
    Entry{Command::kTourBack, "", "Step before", "Page Up", GLFW_KEY_PAGE_UP, false, false, nullptr},
};
constexpr std::array<std::string_view, 6> kMenus = {"File", "Edit", "View", "Add", "Path", "Help"};

// Keys that mean the same as one of the list.
KeyPress usual(KeyPress press) {
    if (press.control && press.key == GLFW_KEY_Y) press = {GLFW_KEY_Z, true, true};
    if (press.control && press.key == GLFW_KEY_KP_ADD) press.key = GLFW_KEY_EQUAL;
    if (press.control && press.key == GLFW_KEY_KP_SUBTRACT) press.key = GLFW_KEY_MINUS;
    if (press.key != GLFW_KEY_Z && press.key != GLFW_KEY_S && press.key != GLFW_KEY_X) press.shift = false;
    return press;
}

const char* menu_help(Command command) {
    switch (command) {
        case Command::kPotential: return kPotentialHelp;
        case Command::kOrders: return kOrdersHelp;
        case Command::kNavigate: return kNavigateHelp;
        default: return "";
    }
}

}  // namespace

std::optional<Action> action_of(const KeyPress& press) {
    const KeyPress key = usual(press);
    for (const Overlay* overlay : overlays())
        if (overlay->key != 0 && overlay->key == key.key && !key.control && !key.shift)
            return Action{Command::kOverlay, overlay};
    for (const Panel* panel : panels())
        if (panel->key != 0 && panel->key == key.key && panel->control == key.control && !key.shift)
            return Action{Command::kPanel, nullptr, panel};
    const auto found = std::ranges::find_if(kEntries, [&](const Entry& entry) {
        return entry.key != 0 && entry.key == key.key && entry.control == key.control && entry.shift == key.shift;
    });
    return found == kEntries.end() ? std::nullopt : std::optional(Action{found->command});
}

std::string why_not(const Action& action, const ViewState& view) {
    if (action.overlay != nullptr)
        return action.overlay->why_not != nullptr ? action.overlay->why_not(view) : std::string();
    if (action.panel != nullptr) return action.panel->why_not != nullptr ? action.panel->why_not(view) : std::string();
    switch (action.command) {
        case Command::kOrders:  // one side may have them
            return view.side_b != nullptr && no_orders(view.side_b->scene).empty() ? "" : no_orders(view.scene);
        case Command::kSwapSides: return view.side_b == nullptr ? "Only in a comparison (X)" : "";
        default: return {};
    }
}

std::optional<Action> draw_menu(const ViewState& view, bool escape) {
    std::optional<Action> chosen;
    const auto item = [&](const Action& action, const char* name, const char* keys, bool shown, const char* help) {
        const std::string reason = why_not(action, view);
        if (ImGui::MenuItem(name, keys, shown && reason.empty(), reason.empty())) chosen = action;
        tooltip(reason.empty() ? help : reason, TooltipPlace::kBesideWindow);
    };
    if (!ImGui::BeginMainMenuBar()) return chosen;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    for (const std::string_view menu : kMenus) {
        // What does not fit below its name is scrolled to, in place of lying over it.
        ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {screen.x, std::max(screen.y - menu_height(), 1.0f)});
        if (!ImGui::BeginMenu(menu.data())) continue;
        if (escape) ImGui::CloseCurrentPopup();
        for (const Entry& entry : kEntries) {
            if (entry.menu != menu) continue;
            if (entry.begins_group) ImGui::Separator();
            if (entry.command == Command::kPanel) {
                for (const Panel* each : panels())
                    if (each->menu == menu)
                        item({Command::kPanel, nullptr, each}, each->name, each->keys, is_open(view, *each),
                             each->help);
                continue;
            }
            if (entry.command == Command::kOverlay) {
                for (const Overlay* each : overlays())
                    item({Command::kOverlay, each}, each->name, each->keys, shows(view, *each), each->help);
                continue;
            }
            const bool compared = entry.command == Command::kCompare && view.side_b != nullptr;
            item({entry.command}, entry.name, entry.keys, compared || (entry.shown != nullptr && view.*entry.shown),
                 menu_help(entry.command));
        }
        ImGui::EndMenu();
    }
    ImGui::EndMainMenuBar();
    return chosen;
}

float menu_height() { return ImGui::GetFrameHeight(); }

}  // namespace nullscope::viewer
