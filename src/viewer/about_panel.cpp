#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>

#include "base/credits.h"
#include "version/version.h"
#include "viewer/panel_rows.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

void draw_about(PanelPlace& place) {
    const gl::Info& info = place.facts.info;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * screen.x, 0.5f * screen.y}, ImGuiCond_Appearing, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(40.0f * em(), 0.9f * screen.x), 0.0f});
    if (ImGui::Begin("About nullscope", &place.open, ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse)) {
        const std::string text = fmt::format("nullscope {}\nOpenGL {}\n{}\n{}\n\n{}", kVersionText, info.version,
                                             info.vendor, info.renderer, kCredits);
        ImGui::TextWrapped("%s", text.c_str());
        if (ImGui::Button("Copy")) ImGui::SetClipboardText(text.c_str());
    }
    ImGui::End();
}

}  // namespace

// Version, driver and credits, to be copied.
const Panel kAboutPanel{
    .menu = "Help",
    .name = "About",
    .words = "version, driver, credits",
    .draw = draw_about,
};

}  // namespace nullscope::viewer
