#include "viewer/recording_sign.h"

#include <fmt/format.h>
#include <imgui.h>

#include <string>

#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr float kRadius = 0.34f, kSignGap = 0.95f;  // of the font's size: of the dot; from its left to the words
constexpr float kLeastRoom = 9.0f;                  // likewise
constexpr ImU32 kRed = IM_COL32(240, 60, 50, 255);

void draw_words(const std::string& words) {
    ImGui::Dummy({kSignGap * em(), ImGui::GetTextLineHeight()});
    ImGui::SameLine(0.0f, 0.0f);
    ImGui::TextUnformatted(words.c_str());
    const float middle = 0.5f * (ImGui::GetItemRectMin().y + ImGui::GetItemRectMax().y),
                left = ImGui::GetItemRectMin().x - kSignGap * em();
    ImGui::GetWindowDrawList()->AddCircleFilled({left + kRadius * em(), middle}, kRadius * em(), kRed);
}

}  // namespace

float draw_recording_sign(double recorded_s, float left, float right, float top) {
    const auto whole = static_cast<long long>(recorded_s);
    const std::string words = fmt::format("REC {}:{:02}", whole / 60, whole % 60);
    if (right - left < kLeastRoom * em()) {
        if (!ImGui::BeginMainMenuBar()) return 0.0f;  // the one that is there
        ImGui::SetCursorPosX(ImGui::GetWindowWidth() - ImGui::CalcTextSize(words.c_str()).x - 2.0f * kSignGap * em());
        draw_words(words);
        ImGui::EndMainMenuBar();
        return 0.0f;
    }
    float height = 0.0f;
    overlay("##recording", right, top, 1.0f, 0.0f, 0.9f, [&] {
        draw_words(words);
        height = ImGui::GetWindowHeight();
    });
    return height;
}

}  // namespace nullscope::viewer
