#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>

#include "viewer/menu.h"
#include "viewer/panel_rows.h"
#include "viewer/panel_system.h"
#include "viewer/panels.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr float kPanelWidth = 19.0f;  // of the font's size

void draw_side_panel(PanelPlace& place) {
    ViewState& view = place.view;
    const FrameFacts& facts = place.facts;
    const bool escape = place.escape;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float margin = kPanelMargin * em(),
                tallest = std::max(screen.y - menu_height() - status_height() - 2.0f * margin, 4.0f * em());
    const float width = std::min(kPanelWidth * em(), std::max(screen.x - 2.0f * margin, 4.0f * em()));
    ImGui::SetNextWindowPos({margin, menu_height() + margin});
    ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, tallest});
    constexpr ImGuiWindowFlags kFlags =
        (kFixed & ~ImGuiWindowFlags_NoScrollbar & ~ImGuiWindowFlags_NoNav) | ImGuiWindowFlags_AlwaysAutoResize;
    if (ImGui::Begin(kSideWindow, nullptr, kFlags)) {
        scene_section(view, escape);
        // True if it is open. ImGui names widgets by section: several have a "Brightness".
        constexpr ImGuiTreeNodeFlags kShut = ImGuiTreeNodeFlags_None, kOpen = ImGuiTreeNodeFlags_DefaultOpen;
        const auto part = [&](const char* name, ImGuiTreeNodeFlags flags, auto&& body) {
            if (!ImGui::CollapsingHeader(name, flags)) return false;
            const bool opened = ImGui::IsItemToggledOpen();
            const float start = ImGui::GetItemRectMin().y;
            ImGui::PushID(name);
            place.changed |= body();
            ImGui::PopID();
            if (opened) scroll_into_view(start);
            return true;
        };
        part("Camera", kOpen, [&] { return camera_section(view); });
        part("Speed of the camera", kOpen, [&] { return boost_section(view); });
        part("Lens", kOpen, [&] { return lens_section(view); });
        part("Disc", kShut, [&] { return disc_section(view, escape); });
        part("Sky", kShut, [&] { return sky_section(view, escape); });
        part("Light", kShut, [&] { return light_section(view, escape); });
        part("Spacetime", kShut, [&] { return spacetime_section(view, escape); });
        view.show_accuracy = part("Accuracy", kShut, [&] { return accuracy_section(view, facts, escape); });
        view.show_effects = part("Effects", kShut, [&] { return effects_section(view, facts); });
        part("Free fall", kShut, [&] { return fall_section(view); });
        part("Clock", kShut, [&] { return clock_section(view); });
        view.show_numbers = part("Numbers", kShut, [&] { return numbers_section(view, facts); });
    }
    ImGui::End();
}

}  // namespace

float side_panel_right() { return (kPanelWidth + kPanelMargin) * em(); }

const Panel kSidePanel{
    .menu = "View",
    .name = "Panels",
    .keys = "Tab",
    .key = GLFW_KEY_TAB,
    .words = "all panels at the edges",
    .where = Panel::Where::kDocked,
    .at_first = true,
    .escapes = false,
    .draw = draw_side_panel,
};

}  // namespace nullscope::viewer
