#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "viewer/overlay.h"
#include "viewer/panel_rows.h"
#include "viewer/panels.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

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
    {"O", "colour image orders"},
    {"Ctrl + Tab", "panels by arrow keys and Enter"},
    {"F11", "full screen"},
    {"F12", "save the picture without panels"},
    {"Ctrl + S", "save the scene as a file"},
    {"Ctrl + Z Y", "undo, redo"},
    {"F9", "record the flight, stop"},
    {"L", "play the path, pause"},
    {"F5", "read the scene again"},
    {"Ctrl + +, -", "larger, smaller text"},
    {"Ctrl + C V", "copy, paste the view as text"},
    {"Ctrl + B", "bookmark this view"},
    {"X", "keep this on the right, to compare"},
    {"Shift + X", "swap both sides"},
    {"Ctrl + O", "gallery; a file can be dropped, too"},
    {"F", "fall freely, pause"},
    {"Page Up, Down", "tour: back, next"},
    {"Escape, Ctrl + Q", "close what is open; quit"},
};

// With those of overlays and panels.
std::vector<std::pair<std::string, const char*>> listed_keys() {
    std::vector<std::pair<std::string, const char*>> keys(std::begin(kFixedKeys), std::end(kFixedKeys));
    auto at = std::next(std::ranges::find(keys, "O", [](const auto& key) { return key.first; }));
    const auto add = [&](const char* written, const char* words) {
        at = std::next(keys.insert(at, {spaced(written), words}));
    };
    for (const Overlay* overlay : overlays())
        if (overlay->key != 0) add(overlay->keys, overlay->key_words);
    for (const Panel* panel : panels())
        if (panel->key != 0) add(panel->keys, panel->words);
    return keys;
}

// In as many columns as the window has room for; what does not fit is scrolled to.
void draw_keys(PanelPlace& place) {
    constexpr float kBacking = 0.95f;               // readable over the side panel in a small window
    constexpr float kColumn = 8.5f, kBoth = 24.0f;  // of the font's size: of the keys, of a whole column
    const auto listed = listed_keys();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float margin = kPanelMargin * em(), line = ImGui::GetTextLineHeightWithSpacing(),
                room = screen.y - place.top - 2.0f * margin;
    const auto whole = [](float number) { return static_cast<std::size_t>(std::max(number, 1.0f)); };
    const std::size_t most = whole((screen.x - 2.0f * em()) / (kBoth * em()));  // columns
    const auto shared = [&](std::size_t columns) { return (listed.size() + columns - 1) / columns; };
    const std::size_t rows = std::max(whole(room / line - 1.0f), shared(most));
    const std::size_t fit = shared((listed.size() + rows - 1) / rows);  // columns as long as each other
    const bool scrolls = static_cast<float>(fit) * line + em() > room;
    ImGui::SetNextWindowPos({screen.x - margin, place.top + margin}, ImGuiCond_Always, {1.0f, 0.0f});
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {screen.x, room});
    ImGui::SetNextWindowBgAlpha(kBacking);
    constexpr ImGuiWindowFlags kFlags = (kFixed & ~ImGuiWindowFlags_NoScrollbar) | ImGuiWindowFlags_AlwaysAutoResize;
    if (ImGui::Begin("##keys", nullptr, scrolls ? kFlags : kFlags | ImGuiWindowFlags_NoInputs)) {
        const ImVec2 corner = ImGui::GetCursorPos();
        for (std::size_t i = 0; i < listed.size(); ++i) {
            const auto& [keys, what] = listed[i];
            const std::size_t column = i / fit, row = i % fit;
            const float left = corner.x + static_cast<float>(column) * kBoth * em();
            ImGui::SetCursorPos({left, corner.y + static_cast<float>(row) * line});
            ImGui::TextUnformatted(keys.c_str());
            ImGui::SameLine(left + kColumn * em());
            ImGui::TextDisabled("%s", what);
        }
    }
    ImGui::End();
}

}  // namespace

const Panel kKeysPanel{
    .menu = "Help",
    .name = "Keys",
    .keys = "F1",
    .key = GLFW_KEY_F1,
    .words = "the list of keys",
    .draw = draw_keys,
};

}  // namespace nullscope::viewer
