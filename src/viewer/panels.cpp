#include "viewer/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "viewer/sections.h"

namespace nullscope::viewer {
namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                    ImGuiWindowFlags_NoNav;
constexpr float kPanelWidth = 19.0f;  // of the font's size
constexpr float kMargin = 0.6f;

constexpr std::pair<const char*, const char*> kKeys[] = {
    {"Left drag", "look: what is grabbed follows the hand"},
    {"Right drag, Q E", "roll"},
    {"Wheel", "distance to the horizon"},
    {"Shift + wheel", "field of view"},
    {"W S", "fly ahead, back"},
    {"A D", "fly left, right"},
    {"Space C", "fly up, down"},
    {"R", "the scene's own camera"},
    {"H", "error of every pixel over the picture"},
    {"P", "the ray of the pixel under the cursor"},
    {"Tab", "panels on and off"},
    {"F1", "this list on and off"},
    {"F12", "save the picture, without panels"},
    {"Escape", "quit"},
};

constexpr const char* kCredits =
    "Sky: 118 216 Hipparcos stars (ESA; XHIP, Anderson and Francis 2012) by way of d3-celestial (O. Frohn); "
    "Milky Way outlines by J. R. Vieira";

float em() { return ImGui::GetFontSize(); }
float status_height() { return ImGui::GetFrameHeight() + 0.2f * em(); }

bool section(const char* name, bool open) {
    return ImGui::CollapsingHeader(name, open ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
}

bool side_panel(ViewState& view, const AccuracyPanel& accuracy, const EffectsPanel& effects, bool escape) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float margin = kMargin * em(), tallest = std::max(screen.y - status_height() - 2.0f * margin, 4.0f * em());
    const float width = std::min(kPanelWidth * em(), std::max(screen.x - 2.0f * margin, 4.0f * em()));
    ImGui::SetNextWindowPos({margin, margin});
    ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, tallest});
    bool changed = false;
    const ImGuiWindowFlags flags = (kFixed & ~ImGuiWindowFlags_NoScrollbar) | ImGuiWindowFlags_AlwaysAutoResize;
    if (ImGui::Begin("##side", nullptr, flags)) {
        const auto any = [&changed](bool one) { changed = changed || one; };
        any(scene_section(view, escape));
        // ImGui names widgets by section: several have a "Brightness".
        const auto part = [&](const char* name, bool open, auto&& body) {
            if (!section(name, open)) return;
            ImGui::PushID(name);
            any(body());
            ImGui::PopID();
        };
        part("Camera", true, [&] { return camera_section(view); });
        part("Boost", true, [&] { return boost_section(view); });
        part("Lens", true, [&] { return lens_section(view); });
        part("Disc", false, [&] { return disc_section(view); });
        part("Sky", false, [&] { return sky_section(view, escape); });
        part("Light", false, [&] { return light_section(view, escape); });
        part("Spacetime", false, [&] { return spacetime_section(view, escape); });
        view.show_accuracy = false;
        part("Accuracy", false, [&] {
            view.show_accuracy = true;
            return accuracy_section(view, accuracy, escape);
        });
        view.show_effects = false;
        part("Effects", false, [&] {
            view.show_effects = true;
            return effects_section(view, effects);
        });
        part("Let go", false, [&] { return fall_section(view); });
        part("Clock", false, [&] { return clock_section(view); });
    }
    ImGui::End();
    return changed;
}

// Nothing where nothing is done.
std::string progress_words(const PaintProgress& progress) {
    using Stage = PaintProgress::Stage;
    switch (progress.stage) {
        case Stage::kIdle: return "";
        case Stage::kPreparing: return "preparing";
        case Stage::kCompiling: return "compiling shaders";
        case Stage::kDrawing: return fmt::format("drawing {:.0f} %", 100.0 * progress.rows / std::max(progress.of, 1));
    }
    return "";
}

void status_line(const FrameFacts& facts) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.0f, screen.y - status_height()});
    ImGui::SetNextWindowSize({screen.x, status_height()});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {kMargin * em(), 0.25f * em()});
    if (ImGui::Begin("##status", nullptr, kFixed | ImGuiWindowFlags_NoInputs)) {
        const std::string took = !facts.picture ? ""
                                 : facts.coarse ? "coarse"
                                                : fmt::format("{:.1f} ms", facts.picture_ms);
        const std::string work = progress_words(facts.progress);
        const std::string rate = facts.fps > 0.0 ? fmt::format("{:.0f} fps", facts.fps) : "idle";
        ImGui::TextUnformatted((facts.fps <= 0.0 && !work.empty() ? work : took + "  " + rate).c_str());
        const std::string tables =
            facts.picture ? fmt::format("table {:.0f} ms, rows {:.1f} ms     ", facts.table_ms, facts.rows_ms) : "";
        const std::string rest = fmt::format("{} x {}     {}OpenGL {}     {}", facts.size.width, facts.size.height,
                                             tables, facts.version, facts.renderer);
        ImGui::SameLine(9.5f * em());
        ImGui::TextDisabled("%s", rest.c_str());
        const char* hint = "F1 keys   Tab panels";
        const float left = screen.x - ImGui::CalcTextSize(hint).x - kMargin * em();
        if (9.5f * em() + ImGui::CalcTextSize(rest.c_str()).x + em() < left) {
            ImGui::SameLine(left);
            ImGui::TextDisabled("%s", hint);
        }
    }
    ImGui::End();
    ImGui::PopStyleVar(3);
}

void keys_window() {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x - kMargin * em(), kMargin * em()}, ImGuiCond_Always, {1.0f, 0.0f});
    ImGui::SetNextWindowBgAlpha(0.95f);  // readable over the side panel in a small window
    if (ImGui::Begin("##keys", nullptr, kFixed | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs)) {
        for (const auto& [keys, what] : kKeys) {
            ImGui::TextUnformatted(keys);
            ImGui::SameLine(8.5f * em());
            ImGui::TextDisabled("%s", what);
        }
        ImGui::Separator();
        ImGui::PushTextWrapPos(24.0f * em());
        ImGui::TextUnformatted(kCredits);
        ImGui::PopTextWrapPos();
    }
    ImGui::End();
}

void message_window(const std::string& message) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * screen.x, screen.y - status_height() - em()}, ImGuiCond_Always, {0.5f, 1.0f});
    if (ImGui::Begin("##message", nullptr, kFixed | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs))
        ImGui::TextUnformatted(message.c_str());
    ImGui::End();
}

}  // namespace

void draw_first_wait(const std::string& scene, const PaintProgress& progress) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.AddRectFilled({0.0f, 0.0f}, screen, IM_COL32(0, 0, 0, 255));
    const std::string work = progress_words(progress), words = scene + (work.empty() ? "" : ": " + work);
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    const float width = 12.0f * em(), height = 0.15f * em(), left = 0.5f * (screen.x - width), top = 0.5f * screen.y;
    draw.AddText({0.5f * (screen.x - size.x), top - 1.4f * em()}, ImGui::GetColorU32(ImGuiCol_TextDisabled),
                 words.c_str());
    const float share = static_cast<float>(progress.rows) / static_cast<float>(std::max(progress.of, 1));
    draw.AddRectFilled({left, top}, {left + width, top + height}, ImGui::GetColorU32(ImGuiCol_FrameBg));
    draw.AddRectFilled({left, top}, {left + share * width, top + height}, ImGui::GetColorU32(ImGuiCol_CheckMark));
}

bool draw_panels(ViewState& view, const FrameFacts& facts, const AccuracyPanel& accuracy, const EffectsPanel& effects,
                 const std::string& message, bool escape) {
    bool changed = false;
    if (view.show_errors)
        draw_error_legend(accuracy.facts, ImGui::GetIO().DisplaySize.y - (view.show_panels ? status_height() : 0.0f));
    if (view.show_panels) {
        changed = side_panel(view, accuracy, effects, escape);
        status_line(facts);
    }
    if (view.show_keys) keys_window();
    if (!message.empty()) message_window(message);
    return changed;
}

}  // namespace nullscope::viewer
