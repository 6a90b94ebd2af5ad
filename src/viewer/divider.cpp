#include "viewer/divider.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr float kReach = 0.5f;     // of the font's size: how near the pointer takes the line
constexpr float kLine = 0.08f;     // width of the line
constexpr float kHandle = 0.55f;   // radius of the handle
constexpr float kGap = 0.6f;       // between line and labels
constexpr float kPadding = 0.35f;  // about the words of a label

// Beside the line, where there is room; else its letter alone.
void draw_label(const std::string& words, float x, float top, bool leftwards, float room) {
    const float padding = kPadding * em(), gap = kGap * em();
    std::string shown = words;
    const auto width = [&] { return ImGui::CalcTextSize(shown.c_str()).x + 2.0f * padding; };
    if (width() + 2.0f * gap > room) shown = words.substr(0, 1);
    if (width() + 2.0f * gap > room) return;
    const float left = leftwards ? x - gap - width() : x + gap;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.AddRectFilled({left, top}, {left + width(), top + em() + 2.0f * padding}, packed(palette().panel), padding);
    draw.AddText({left + padding, top + padding}, packed(palette().text), shown.c_str());
}

void draw_handle(float x, float y) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const float radius = kHandle * em(), tip = 0.65f * radius, base = 0.2f * radius, half = 0.35f * radius;
    const ImU32 arrow = IM_COL32(40, 44, 52, 255);
    draw.AddCircleFilled({x, y}, radius + 1.0f, IM_COL32(0, 0, 0, 130));
    draw.AddCircleFilled({x, y}, radius, IM_COL32(255, 255, 255, 235));
    draw.AddTriangleFilled({x - tip, y}, {x - base, y - half}, {x - base, y + half}, arrow);
    draw.AddTriangleFilled({x + tip, y}, {x + base, y + half}, {x + base, y - half}, arrow);
}

}  // namespace

void Divider::follow(const Input& input, int width, double least, bool mouse_taken) {
    const double reach = kReach * static_cast<double>(em()) * width / static_cast<double>(ImGui::GetIO().DisplaySize.x);
    const double first = std::min(least + reach, 0.5 * width), last = std::max(width - 2.0 * reach, first);
    const auto placed = [&] { return static_cast<int>(std::lround(std::clamp(place_ * width, first, last))); };
    x_ = placed();
    over_ = !mouse_taken && std::fabs(input.x - x_) <= reach;
    if (input.left.pressed && !mouse_taken && !held_ && std::fabs(input.left.pressed_x - x_) <= reach)
        held_ = true, grabbed_ = input.left.pressed_x - x_;
    has_mouse_ = held_;
    if (!held_) return;
    held_ = input.left.held;
    place_ = std::clamp((held_ ? input.x : input.left.released_x) - grabbed_, first, last) / width;
    x_ = placed();
}

void Divider::draw(const std::pair<std::string, std::string>& words, float left, float top, float bottom,
                   float unit) const {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const float x = unit * static_cast<float>(x_), half = 0.5f * std::max(kLine * em(), 1.0f);
    draw.AddRectFilled({x - half - 1.0f, top}, {x + half + 1.0f, bottom}, IM_COL32(0, 0, 0, 130));
    draw.AddRectFilled({x - half, top}, {x + half, bottom}, IM_COL32(255, 255, 255, 200));
    draw_handle(x, 0.5f * (top + bottom));
    const float below = top + kGap * em();
    draw_label(words.first, x, below, true, x - left);
    draw_label(words.second, x, below, false, ImGui::GetIO().DisplaySize.x - x);
}

}  // namespace nullscope::viewer
