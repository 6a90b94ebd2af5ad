#include "viewer/panels.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <utility>

#include "base/credits.h"
#include "version/version.h"
#include "viewer/menu.h"
#include "viewer/overlay.h"
#include "viewer/panel_system.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                    ImGuiWindowFlags_NoNav;
constexpr float kPanelWidth = 19.0f;  // of the font's size
constexpr float kPanelMargin = 0.6f;

constexpr std::pair<const char*, const char*> kFixedKeys[] = {
    {"Left drag", "look around"},
    {"Click on a body", "its section of the scene editor"},
    {"Right drag, Q E", "roll"},
    {"Middle drag", "around the hole; also Alt + drag"},
    {"Wheel", "distance to the horizon"},
    {"Shift + wheel", "field of view"},
    {"Z + wheel", "zoom into the photon ring"},
    {"W S", "fly forward, back"},
    {"A D", "fly left, right"},
    {"Space C", "fly up, down"},
    {"R", "return to the scene's camera"},
    {"H", "show the error of every pixel"},
    {"P", "show the ray under the cursor"},
    {"O", "colour image orders"},
    {"Tab", "show or hide the panels"},
    {"Ctrl + Tab", "panels by arrow keys and Enter"},
    {"F1", "show or hide this list"},
    {"F11", "full screen"},
    {"F12", "save the picture without panels"},
    {"Ctrl + S", "save the scene as a file"},
    {"Ctrl + Z Y", "undo, redo"},
    {"Ctrl + E", "scene editor: everything in it"},
    {"F9", "record the flight, stop"},
    {"L, Ctrl + T", "play the path; timeline"},
    {"F5", "read the scene again"},
    {"Ctrl + +, -", "larger, smaller text"},
    {"Ctrl + C V", "copy, paste the view as text"},
    {"Ctrl + B, B", "bookmark this view; bookmarks"},
    {"X", "keep this on the right, to compare"},
    {"Shift + X", "swap both sides"},
    {"Ctrl + O", "gallery; a file can be dropped, too"},
    {"F", "fall freely, pause"},
    {"Page Up, Down", "tour: back, next"},
    {"Escape, Ctrl + Q", "close what is open; quit"},
};

// With those of overlays.
std::vector<std::pair<const char*, const char*>> listed_keys() {
    std::vector<std::pair<const char*, const char*>> keys(std::begin(kFixedKeys), std::end(kFixedKeys));
    auto at =
        std::ranges::find(keys, std::string_view("P"), [](const auto& key) { return std::string_view(key.first); });
    for (const Overlay* overlay : overlays())
        if (overlay->key != 0) at = keys.insert(std::next(at), {overlay->keys, overlay->key_words});
    return keys;
}

bool side_panel(ViewState& view, const FrameFacts& facts, bool escape) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float margin = kPanelMargin * em(),
                tallest = std::max(screen.y - menu_height() - status_height() - 2.0f * margin, 4.0f * em());
    const float width = std::min(kPanelWidth * em(), std::max(screen.x - 2.0f * margin, 4.0f * em()));
    ImGui::SetNextWindowPos({margin, menu_height() + margin});
    ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, tallest});
    bool changed = false;
    constexpr ImGuiWindowFlags kFlags =
        (kFixed & ~ImGuiWindowFlags_NoScrollbar & ~ImGuiWindowFlags_NoNav) | ImGuiWindowFlags_AlwaysAutoResize;
    if (ImGui::Begin(kSidePanel, nullptr, kFlags)) {
        scene_section(view, escape);
        // True if it is open. ImGui names widgets by section: several have a "Brightness".
        constexpr ImGuiTreeNodeFlags kShut = ImGuiTreeNodeFlags_None, kOpen = ImGuiTreeNodeFlags_DefaultOpen;
        const auto part = [&](const char* name, ImGuiTreeNodeFlags flags, auto&& body) {
            if (!ImGui::CollapsingHeader(name, flags)) return false;
            const bool opened = ImGui::IsItemToggledOpen();
            const float start = ImGui::GetItemRectMin().y;
            ImGui::PushID(name);
            changed |= body();
            ImGui::PopID();
            if (opened) scroll_into_view(start);
            return true;
        };
        part("Camera", kOpen, [&] { return camera_section(view); });
        part("Speed of the camera", kOpen, [&] { return boost_section(view); });
        part("Lens", kOpen, [&] { return lens_section(view); });
        part("Disc", kShut, [&] { return disc_section(view); });
        part("Sky", kShut, [&] { return sky_section(view, escape); });
        part("Light", kShut, [&] { return light_section(view, escape); });
        part("Spacetime", kShut, [&] { return spacetime_section(view, escape); });
        view.show_accuracy = part("Accuracy", kShut, [&] { return accuracy_section(view, facts, escape); });
        view.show_effects = part("Effects", kShut, [&] { return effects_section(view, facts); });
        part("Free fall", kShut, [&] { return fall_section(view); });
        part("Clock", kShut, [&] { return clock_section(view); });
        part("Numbers", kShut, [&] { return numbers_section(view); });
    }
    ImGui::End();
    return changed;
}

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

// In as many columns as the window has room for; what does not fit is scrolled to.
void keys_window(float top) {
    constexpr float kBacking = 0.95f;               // readable over the side panel in a small window
    constexpr float kColumn = 8.5f, kBoth = 24.0f;  // of the font's size: of the keys, of a whole column
    const auto listed = listed_keys();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float margin = kPanelMargin * em(), line = ImGui::GetTextLineHeightWithSpacing(),
                room = screen.y - top - 2.0f * margin;
    const auto whole = [](float number) { return static_cast<std::size_t>(std::max(number, 1.0f)); };
    const std::size_t most = whole((screen.x - 2.0f * em()) / (kBoth * em()));  // columns
    const auto shared = [&](std::size_t columns) { return (listed.size() + columns - 1) / columns; };
    const std::size_t rows = std::max(whole(room / line - 1.0f), shared(most));
    const std::size_t fit = shared((listed.size() + rows - 1) / rows);  // columns as long as each other
    const bool scrolls = static_cast<float>(fit) * line + em() > room;
    ImGui::SetNextWindowPos({screen.x - margin, top + margin}, ImGuiCond_Always, {1.0f, 0.0f});
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {screen.x, room});
    ImGui::SetNextWindowBgAlpha(kBacking);
    constexpr ImGuiWindowFlags kFlags = (kFixed & ~ImGuiWindowFlags_NoScrollbar) | ImGuiWindowFlags_AlwaysAutoResize;
    if (ImGui::Begin("##keys", nullptr, scrolls ? kFlags : kFlags | ImGuiWindowFlags_NoInputs)) {
        const ImVec2 corner = ImGui::GetCursorPos();
        for (std::size_t i = 0; i < listed.size(); ++i) {
            const auto [keys, what] = listed[i];
            const std::size_t column = i / fit, row = i % fit;
            const float left = corner.x + static_cast<float>(column) * kBoth * em();
            ImGui::SetCursorPos({left, corner.y + static_cast<float>(row) * line});
            ImGui::TextUnformatted(keys);
            ImGui::SameLine(left + kColumn * em());
            ImGui::TextDisabled("%s", what);
        }
    }
    ImGui::End();
}

}  // namespace

float side_panel_right() { return (kPanelWidth + kPanelMargin) * em(); }
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
        std::tm local{};
        localtime_r(&when, &local);
        ImGui::TextUnformatted(fmt::format("The viewer ended unexpectedly on {:%Y-%m-%d at %H:%M}.", local).c_str());
        if (ImGui::Button("Restore the scene")) answer = LeftScene::kRestored;
        ImGui::SameLine();
        if (ImGui::Button("Discard")) answer = LeftScene::kDiscarded;
    }
    ImGui::End();
    return answer;
}

void draw_about(bool& shown, const gl::Info& info) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * screen.x, 0.5f * screen.y}, ImGuiCond_Appearing, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(40.0f * em(), 0.9f * screen.x), 0.0f});
    if (ImGui::Begin("About nullscope", &shown, ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse)) {
        const std::string text = fmt::format("nullscope {}\nOpenGL {}\n{}\n{}\n\n{}", kVersionText, info.version,
                                             info.vendor, info.renderer, kCredits);
        ImGui::TextWrapped("%s", text.c_str());
        if (ImGui::Button("Copy")) ImGui::SetClipboardText(text.c_str());
    }
    ImGui::End();
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

bool draw_panels(ViewState& view, const FrameFacts& facts, float top, float bottom, bool escape) {
    bool changed = false;
    if (view.show_errors) draw_error_legend(facts.accuracy, bottom);
    if (view.show_panels) {
        changed = side_panel(view, facts, escape);
        status_line(facts);
    }
    if (view.show_keys) keys_window(top);
    if (view.show_about) draw_about(view.show_about, facts.info);
    return changed;
}

}  // namespace nullscope::viewer
