#include "viewer/frame_accuracy.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "compare/heat_map.h"
#include "studio/number_words.h"
#include "viewer/texture_id.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

ImU32 heat(double value) {
    const auto colour = heat_colour(value, kPixelHeat);
    return IM_COL32(colour[0], colour[1], colour[2], 255);
}

// The colour bar with a tick and a power of ten at each decade; takes its place in the window.
void colour_bar(float width, float height) {
    constexpr int kSlices = 96;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const double low = std::log10(kPixelHeat.low), high = std::log10(kPixelHeat.high);
    for (int i = 0; i < kSlices; ++i) {
        const double value = std::pow(10.0, low + (high - low) * (i + 0.5) / kSlices);
        draw.AddRectFilled({at.x + width * static_cast<float>(i) / kSlices, at.y},
                           {at.x + width * static_cast<float>(i + 1) / kSlices, at.y + height}, heat(value));
    }
    draw.AddRect(at, {at.x + width, at.y + height}, ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.6f));
    const float tick = 0.3f * ImGui::GetFontSize();
    for (int decade = static_cast<int>(std::lround(low)); decade <= static_cast<int>(std::lround(high)); ++decade) {
        const float x = at.x + width * static_cast<float>((decade - low) / (high - low));
        draw.AddLine({x, at.y + height}, {x, at.y + height + tick}, ImGui::GetColorU32(ImGuiCol_TextDisabled));
        const std::string label = decade == 0 ? "1" : fmt::format("1e{}", decade);
        const float length = ImGui::CalcTextSize(label.c_str()).x;
        const float left = std::clamp(x - 0.5f * length, at.x, at.x + width - length);
        draw.AddText({left, at.y + height + tick}, ImGui::GetColorU32(ImGuiCol_Text), label.c_str());
    }
    ImGui::Dummy({width, height + tick + ImGui::GetFontSize()});
}

std::string state_words(const AccuracyFacts& facts) {
    if (!facts.error.empty()) return facts.error;
    if (!facts.of_this_frame) return "measured when the picture is still";
    if (facts.errors.complete()) return "every pixel measured";
    return fmt::format("measuring: {} of {} pixels", count_words(facts.errors.measured),
                       count_words(facts.errors.pixels));
}

}  // namespace

FrameAccuracy::FrameAccuracy()
    : watch_([this] {
          news_ = true;
          glfwPostEmptyEvent();
      }) {}

void FrameAccuracy::frame_is(const Scene& scene, const Method& method) {
    if (frame_.frame_is(scene, method)) watch_.cancel();
}

bool FrameAccuracy::update(bool wanted, bool moving) {
    if (!wanted && frame_.has_rays() && watch_.measuring()) {
        watch_.cancel();
        frame_.forget_rays();
    }
    frame_.update(wanted, moving);
    return news_.exchange(false) && frame_.has_rays() && wanted;
}

void FrameAccuracy::take_rays(const Scene& scene, RayFrame rays) {
    if (!frame_.takes(scene)) return;
    const Status started = watch_.start(frame_.scene(), std::move(rays));
    error_ = started ? std::string() : started.error().message();
}

bool FrameAccuracy::at_work() const { return asks_for_rays() || watch_.measuring() || news_ || std::isfinite(wait()); }

void FrameAccuracy::draw_overlay() {
    if (!frame_.has_rays() || !error_.empty()) return;
    if (watch_.take_heat(heat_)) overlay_ = gl::make_rgba8_texture(heat_.width, heat_.height, heat_.data.data());
    if (!overlay_) return;
    ImGui::GetBackgroundDrawList()->AddImage(id_of(overlay_), {0.0f, 0.0f}, ImGui::GetIO().DisplaySize);
}

AccuracyFacts FrameAccuracy::facts() const { return {watch_.summary(), frame_.has_rays(), error_}; }

void draw_error_legend(const AccuracyFacts& facts, float bottom) {
    const float em = ImGui::GetFontSize(), margin = 0.6f * em, screen = ImGui::GetIO().DisplaySize.x;
    overlay("##legend", screen - margin, bottom - margin, 1.0f, 1.0f, 0.92f, [&] {
        const float width = std::min(17.0f * em, std::max(screen - 4.0f * margin, 4.0f * em)), swatch = 0.75f * em;
        ImGui::TextUnformatted("Screen error, px");
        const char* fate = "wrong fate";
        ImGui::SameLine(ImGui::GetCursorPosX() + width - (ImGui::CalcTextSize(fate).x + swatch + 0.4f * em));
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float top = at.y + 0.5f * (ImGui::GetTextLineHeight() - swatch);
        ImGui::GetWindowDrawList()->AddRectFilled({at.x, top}, {at.x + swatch, top + swatch},
                                                  heat(std::numeric_limits<double>::infinity()), 0.15f * em);
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + swatch + 0.4f * em);
        ImGui::TextUnformatted(fate);
        colour_bar(width, 0.8f * em);
        ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
        ImGui::TextDisabled("%s", state_words(facts).c_str());
        ImGui::PopTextWrapPos();
    });
}

}  // namespace nullscope::viewer
