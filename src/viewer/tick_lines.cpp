#include "viewer/tick_lines.h"

#include <imgui.h>

#include <cmath>

#include "annotate/ticks.h"

namespace nullscope::viewer {

void draw_tick_lines(const Image<float>& stokes) {
    if (stokes.empty()) return;
    constexpr float kOutline = 2.2f;  // of a line's thickness
    const ImU32 dark = IM_COL32(0, 0, 0, 150), white = IM_COL32(245, 245, 245, 255);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const int width = static_cast<int>(screen.x), height = static_cast<int>(screen.y);
    const auto thick = static_cast<float>(tick_thickness(width, height));
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    for (const Tick& tick : ticks_of(stokes, width, height)) {
        const auto x = static_cast<float>(tick.x), y = static_cast<float>(tick.y),
                   right = static_cast<float>(tick.right), down = -static_cast<float>(tick.up);
        const ImVec2 from{x - right, y - down}, to{x + right, y + down};
        draw.AddLine(from, to, dark, kOutline * thick);
        draw.AddLine(from, to, white, thick);
    }
}

}  // namespace nullscope::viewer
