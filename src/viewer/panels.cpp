#include "viewer/panels.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <utility>

#include "viewer/menu.h"
#include "viewer/panel.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

// Nothing where nothing is done.
std::string progress_words(const PaintProgress& progress) {
    using Stage = PaintProgress::Stage;
    switch (progress.stage) {
        case Stage::kPreparing: return "preparing";
        case Stage::kCompiling: return "compiling shaders";
        case Stage::kDrawing: return fmt::format("drawing {:.0f} %", 100.0 * progress.rows / std::max(progress.of, 1));
        default: return "";
    }
}

void status_line(const FrameFacts& facts) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.0f, screen.y - status_height()});
    ImGui::SetNextWindowSize({screen.x, status_height()});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {kPanelMargin * em(), 0.25f * em()});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0f, 1.0f});
    if (ImGui::Begin("##status", nullptr, kFixed | ImGuiWindowFlags_NoInputs)) {
        const Painting& painting = facts.painting;
        const bool picture = painting.texture != 0;
        const std::string took = !picture            ? ""
                                 : painting.coarse() ? "coarse"
                                                     : fmt::format("{:.1f} ms", facts.picture_ms);
        const std::string work = progress_words(facts.progress);
        const std::string rate = facts.fps > 0.0 ? fmt::format("{:.0f} fps", facts.fps) : "idle";
        ImGui::TextUnformatted((facts.fps <= 0.0 && !work.empty() ? work : took + "  " + rate).c_str());
        const std::string tables =
            picture ? fmt::format("table {:.0f} ms, rows {:.1f} ms", painting.table_ms, painting.rows_ms) : "";
        std::string rest = fmt::format("{} x {}", facts.size.width, facts.size.height);
        const float room = screen.x - (9.5f + kPanelMargin) * em();
        const std::string version = facts.info.version.substr(0, facts.info.version.find(' '));
        for (const std::string& part : {tables, "OpenGL " + version, facts.info.renderer})
            if (const std::string longer = fmt::format("{}     {}", rest, part);
                !part.empty() && ImGui::CalcTextSize(longer.c_str()).x < room)
                rest = longer;
        ImGui::SameLine(9.5f * em());
        ImGui::TextDisabled("%s", rest.c_str());
        const char* hint = "F1 keys   Tab panels";
        const float left = screen.x - ImGui::CalcTextSize(hint).x - kPanelMargin * em();
        if (9.5f * em() + ImGui::CalcTextSize(rest.c_str()).x + em() < left) {
            ImGui::SameLine(left);
            ImGui::TextDisabled("%s", hint);
        }
    }
    ImGui::End();
    ImGui::PopStyleVar(4);
}

}  // namespace

float status_height() { return ImGui::GetFrameHeight() + 0.2f * ImGui::GetFontSize(); }

void draw_message(const std::string& message, float left, float right, float bottom) {
    constexpr float kLeastWidth = 10.0f;                                        // of the font's size
    const float lowest = std::max(bottom - em(), menu_height() + 3.0f * em());  // strips may leave no room
    if (right - left < kLeastWidth * em()) left = 0.0f, right = ImGui::GetIO().DisplaySize.x;
    const float width = right - left - 2.0f * (kPanelMargin * em() + ImGui::GetStyle().WindowPadding.x);
    overlay(
        "##message", 0.5f * (left + right), lowest, 0.5f, 1.0f, 0.9f, [&] { wrapped_text(message, width); },
        OverlayLayer::kTop);
}

void draw_hints() {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    overlay("##hints", 0.5f * screen.x, 0.86f * screen.y, 0.5f, 1.0f, 0.9f, [] {
        ImGui::TextUnformatted("Drag the picture to look around.");
        ImGui::TextUnformatted("Turn the wheel to come nearer; W A S D to fly.");
        ImGui::TextUnformatted("Ctrl + O: more scenes.   F1: all keys.");
    });
}

LeftScene draw_left_scene(const std::filesystem::path& file) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    LeftScene answer = LeftScene::kWaits;
    ImGui::SetNextWindowPos({screen.x - kPanelMargin * em(), 0.3f * screen.y}, ImGuiCond_Always, {1.0f, 0.0f});
    ImGui::SetNextWindowBgAlpha(1.0f);
    if (ImGui::Begin("Changes that were not saved", nullptr,
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_AlwaysAutoResize)) {
        std::error_code error;
        const auto changed = std::chrono::file_clock::to_sys(std::filesystem::last_write_time(file, error));
        const std::time_t when = std::chrono::system_clock::to_time_t(
            std::chrono::time_point_cast<std::chrono::system_clock::duration>(changed));
        ImGui::TextUnformatted(
            fmt::format("The viewer ended unexpectedly on {:%Y-%m-%d at %H:%M}.", fmt::localtime(when)).c_str());
        if (ImGui::Button("Restore the scene")) answer = LeftScene::kRestored;
        ImGui::SameLine();
        if (ImGui::Button("Discard")) answer = LeftScene::kDiscarded;
    }
    ImGui::End();
    return answer;
}

void draw_wait(const std::string& scene, const PaintProgress& progress, bool over_picture) {
    constexpr int kDimmed = 200;  // of 255
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.AddRectFilled({0.0f, 0.0f}, screen, IM_COL32(0, 0, 0, over_picture ? kDimmed : 255));
    const std::string work = progress_words(progress), words = scene + (work.empty() ? "" : ": " + work);
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    const float width = 12.0f * em(), height = 0.15f * em(), left = 0.5f * (screen.x - width), top = 0.5f * screen.y;
    draw.AddText({0.5f * (screen.x - size.x), top - 1.4f * em()}, packed(dark_palette().dim), words.c_str());
    const float share = static_cast<float>(progress.rows) / static_cast<float>(std::max(progress.of, 1));
    draw.AddRectFilled({left, top}, {left + width, top + height}, packed(dark_palette().field));
    draw.AddRectFilled({left, top}, {left + share * width, top + height}, packed(dark_palette().accent));
}

void draw_frame_facts(const ViewState& view, const FrameFacts& facts, float bottom) {
    if (view.show_errors) draw_error_legend(facts.accuracy, bottom);
    if (docked(view)) status_line(facts);
}

}  // namespace nullscope::viewer
