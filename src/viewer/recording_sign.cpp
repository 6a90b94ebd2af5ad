#include "viewer/recording_sign.h"

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/widgets.h"

namespace nullscope::viewer {

float draw_recording_sign(double recorded_s, float right, float top) {
    constexpr float kRadius = 0.34f, kGap = 0.95f;  // of the font's size: of the dot; from its left to the words
    constexpr ImU32 kRed = IM_COL32(240, 60, 50, 255);
    float height = 0.0f;
    overlay("##recording", right, top, 1.0f, 0.0f, 0.9f, [&] {
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const float line = ImGui::GetTextLineHeight();
        ImGui::GetWindowDrawList()->AddCircleFilled({corner.x + kRadius * em(), corner.y + 0.5f * line}, kRadius * em(),
                                                    kRed);
        ImGui::Dummy({kGap * em(), line});
        ImGui::SameLine(0.0f, 0.0f);
        const auto whole = static_cast<long long>(recorded_s);
        ImGui::TextUnformatted(fmt::format("REC {}:{:02}", whole / 60, whole % 60).c_str());
        height = ImGui::GetWindowHeight();
    });
    return height;
}

}  // namespace nullscope::viewer
