// Q and U of the picture's light through one orbit of a hot spot, with the present place. Of a comparison: side A.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "viewer/panel_rows.h"
#include "viewer/panels.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr float kLoopSide = 15.0f;                        // of the font's size
constexpr ImU32 kLoopGround = IM_COL32(14, 15, 19, 255);  // in either theme
constexpr ImU32 kLoopCurve = IM_COL32(120, 200, 255, 255), kLoopAxis = IM_COL32(150, 165, 190, 90);
constexpr const char* kLoopHelp =
    "Q to the right and U up, of all light in the picture, over the mean of I. Lines: Q = 0 and U = 0. The dot is now; "
    "small dots are "
    "eighths of the orbit.";

// Equal axes about all of the shape and the origin.
class LoopAxes {
public:
    LoopAxes(const std::vector<std::array<double, 2>>& shape, float side) : corner_(ImGui::GetCursorScreenPos()) {
        std::array<double, 2> low{}, high{};
        for (const auto& point : shape)
            for (std::size_t c = 0; c < 2; ++c)
                low[c] = std::min(low[c], point[c]), high[c] = std::max(high[c], point[c]);
        constexpr double kLeast = 1e-6, kRoom = 0.86;
        scale_ = kRoom * side / std::max({high[0] - low[0], high[1] - low[1], kLeast});
        for (std::size_t c = 0; c < 2; ++c) middle_[c] = 0.5 * (low[c] + high[c]);
        centre_ = {corner_.x + 0.5f * side, corner_.y + 0.5f * side};
    }
    ImVec2 at(const std::array<double, 2>& point) const {
        return {centre_.x + static_cast<float>(scale_ * (point[0] - middle_[0])),
                centre_.y - static_cast<float>(scale_ * (point[1] - middle_[1]))};
    }
    ImVec2 corner() const { return corner_; }

private:
    ImVec2 corner_, centre_;
    std::array<double, 2> middle_{};
    double scale_ = 1.0;
};

void draw_loop_curve(const LoopWatch& watch, const std::vector<std::array<double, 2>>& shape, float side) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const LoopAxes axes(shape, side);
    const ImVec2 from = axes.corner(), to{from.x + side, from.y + side}, origin = axes.at({0.0, 0.0});
    draw.AddRectFilled(from, to, kLoopGround);
    draw.AddLine({origin.x, from.y}, {origin.x, to.y}, kLoopAxis);
    draw.AddLine({from.x, origin.y}, {to.x, origin.y}, kLoopAxis);
    draw.AddText({to.x - 1.1f * em(), origin.y + 0.1f * em()}, packed(dark_palette().dim), "Q");
    draw.AddText({origin.x + 0.3f * em(), from.y + 0.1f * em()}, packed(dark_palette().dim), "U");
    std::vector<ImVec2> line;
    line.reserve(shape.size());
    for (const auto& point : shape) line.push_back(axes.at(point));
    draw.AddPolyline(line.data(), static_cast<int>(line.size()), kLoopCurve, ImDrawFlags_None, 1.8f);
    constexpr std::size_t kParts = 8;
    for (std::size_t i = 1; i < kParts; ++i)
        if (const std::size_t point = i * (LoopOrder::kPoints - 1) / kParts; point < line.size())
            draw.AddCircleFilled(line[point], 0.16f * em(), kLoopCurve);
    if (const auto now = watch.present()) {
        double light = 0.0;
        for (const StokesPoint& point : watch.loop()) light += point.i / static_cast<double>(watch.loop().size());
        if (light > 0.0)
            draw.AddCircleFilled(axes.at({now->q / light, now->u / light}), 0.35f * em(),
                                 packed(dark_palette().accent));
    }
    ImGui::Dummy({side, side});
    tooltip(kLoopHelp);
}

void draw_loop_words(const LoopWatch& watch, const NumberStyle& style) {
    const auto now = watch.present();
    if (!now || !(now->i > 0.0)) {
        ImGui::TextDisabled("%s", fmt::format("{} of {} times", watch.found(), LoopOrder::kPoints).c_str());
        return;
    }
    const auto percent = [&](double part) { return fixed_words(100.0 * part / now->i, style, 2) + " %"; };
    text_row("Now", "Of the light at this time.");
    ImGui::TextUnformatted(fmt::format("Q {}, U {}", percent(now->q), percent(now->u)).c_str());
    text_row("Polarised", "The root of Q^2 + U^2 over I: what an observer measures who does not resolve the picture.");
    ImGui::TextUnformatted(percent(std::hypot(now->q, now->u)).c_str());
    const int turns = loop_turns(watch.loop());
    text_row(
        "Turns",
        "How often the way along the loop turns round in an orbit: twice with a smaller loop within the large one.");
    ImGui::TextUnformatted(
        !is_closed(watch.loop())
            ? "not closed"
            : fmt::format("{} {}", std::abs(turns), turns < 0 ? "clockwise" : "counterclockwise").c_str());
}

std::string no_loop_of_view(const ViewState& view) { return no_loop(view.scene); }

void draw_loop(PanelPlace& place) {
    LoopWatch& watch = place.parts.loop;
    auto* looked_at = std::any_cast<int>(place.kept);
    if (looked_at == nullptr) looked_at = &place.kept->emplace<int>(-1);
    const Painting& painting = place.facts.painting;
    if (painting.texture != 0 && *looked_at != place.facts.number)
        *looked_at = place.facts.number, watch.look(painting.job.scene, !painting.coarse());
    const float margin = kPanelMargin * em();
    const bool low = is_open(place.view, kHistogramPanel);  // which has the upper corner
    float right = place.right;
    if (const float beside = kTelescopeWidth * em() + margin;
        is_open(place.view, kTelescopePanel) && place.left + 2.0f * beside < right)
        right -= beside;
    ImGui::SetNextWindowPos({right - margin, low ? place.bottom - margin : place.top + margin}, ImGuiCond_Always,
                            {1.0f, low ? 1.0f : 0.0f});
    if (ImGui::Begin("Q-U loop", &place.open,
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing)) {
        if (const std::string reason = no_loop_of_view(place.view); !reason.empty())
            ImGui::TextUnformatted(reason.c_str());
        else {
            draw_loop_curve(watch, loop_shape(watch.loop()), kLoopSide * em());
            draw_loop_words(watch, place.view.numbers);
        }
    }
    ImGui::End();
}

}  // namespace

const Panel kLoopPanel{
    .menu = "View",
    .name = "Q-U loop",
    .keys = "U",
    .key = GLFW_KEY_U,
    .words = "how a hot spot is polarised",
    .help = "Q and U of the picture's light through one orbit of a hot spot, computed in the background.",
    .hides_picture = true,
    .why_not = no_loop_of_view,
    .draw = draw_loop,
    .forget = [](PanelParts& parts) { parts.loop = {}; },
};

}  // namespace nullscope::viewer
