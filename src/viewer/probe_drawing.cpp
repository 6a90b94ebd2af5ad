// How the probe is drawn: charts, their legend, and numbers.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "scene/bodies.h"
#include "studio/palette.h"
#include "viewer/panel_rows.h"
#include "viewer/probe.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr double kFarthestDrawn = 16.0;  // r_s that the inset shows at most
constexpr double kAboutProbe = 2.0;      // of the outermost circle's, where there is no ray to show
constexpr double kWide = 1.25;           // of the camera's radius that it shows
// em: a chart's side, alone, beside another, and at least; names of numbers, in the first column and in the second; where that begins;
// numbers beside a chart, and in two columns
constexpr float kSide = 15.0f, kSideOfTwo = 12.0f, kLeastSide = 8.0f, kNames = 7.2f, kShortNames = 5.0f,
                kFirstColumn = 15.0f, kBeside = 16.0f, kColumns = 27.0f;
constexpr std::size_t kFewRows = 4;  // that are shown at least

std::string probe_words(const ProbeFacts& facts, const Scene& scene) {
    if (facts.hit == kStarHit) return "the star's surface";
    if (facts.hit != 0) return object_name(scene, facts.hit);
    switch (facts.fate) {
        case Fate::kEscaped: return "sky";
        case Fate::kOtherSide: return "the far side's sky";
        case Fate::kCaptured: return "the horizon";
        default: return "nothing";
    }
}

// The ray's plane: circles of landmarks, where the disc's plane is met, the ray and its turning point. About a rotating hole the
// equatorial plane, and the ray as seen from the pole: it stays in no plane.
void draw_path(const ProbeFacts& facts, const std::vector<LandmarkCircle>& circles, const Scene& scene, float side) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const double camera = 1 / facts.zeta0;
    double shown = std::min(kFarthestDrawn, kWide * camera);
    if (facts.path.empty() && !circles.empty()) shown = std::min(shown, kAboutProbe * circles.back().areal);
    const float scale = 0.5f * side / static_cast<float>(shown);
    const ImVec2 middle{corner.x + 0.5f * side, corner.y + 0.5f * side};
    const auto at = [&](double x, double y) {
        return ImVec2(middle.x + scale * static_cast<float>(x), middle.y - scale * static_cast<float>(y));
    };
    const ImU32 bright = packed(dark_palette().text);
    draw.AddRectFilled(corner, {corner.x + side, corner.y + side}, IM_COL32(6, 8, 14, 255));
    draw.PushClipRect(corner, {corner.x + side, corner.y + side}, true);
    draw_circles(circles, middle.x, middle.y, scale);
    if (scene.disc && facts.disc) {  // the disc's plane cuts this one along a line
        const double c = std::cos(*facts.disc), s = std::sin(*facts.disc), in = scene.disc->inner,
                     out = scene.disc->outer;
        for (const double way : {1.0, -1.0})
            draw.AddLine(at(way * in * c, way * in * s), at(way * out * c, way * out * s), IM_COL32(255, 176, 96, 200),
                         2.0f);
    }
    for (std::size_t i = 1; i < facts.path.size(); ++i)
        draw.AddLine(at(facts.path[i - 1].x, facts.path[i - 1].y), at(facts.path[i].x, facts.path[i].y),
                     IM_COL32(120, 200, 255, 255), 1.5f);
    if (!facts.path.empty() && std::isfinite(facts.turn_r)) {
        const auto nearest = std::ranges::min_element(
            facts.path, {}, [](const PathPoint& place) { return std::hypot(place.x, place.y); });
        draw.AddCircle(at(nearest->x, nearest->y), 3.5f, bright);
    }
    if (!facts.potential) {
        const float small = 0.8f * ImGui::GetFontSize();
        draw.AddText(ImGui::GetFont(), small, {corner.x + 0.6f * small, corner.y + side - 1.6f * small},
                     packed(dark_palette().dim),
                     facts.path.empty() ? "seen from the pole; the ray is not drawn" : "seen from the pole");
    }
    const double beside = facts.potential || facts.path.empty() ? camera : facts.path.front().x;
    draw.AddCircleFilled(at(std::min(beside, shown), 0), 3.0f, bright);  // the camera, or the edge towards it
    draw.PopClipRect();
    ImGui::Dummy({side, side});
}

using Rows = std::vector<std::pair<const char*, std::string>>;

Rows rows_of(const ProbeFacts& f, const Scene& scene, const NumberStyle& style) {
    const reference::Shift g = f.shift.value_or(reference::Shift{kNotANumber, kNotANumber});
    const auto number = [&](double value) { return number_words(value, style); };
    return {{"Seen", probe_words(f, scene) + (std::isfinite(f.hit_r) ? " at " + length_words(f.hit_r, style, 4) : "")},
            {"b = L/E", length_words(f.impact, style)},
            {"b / b_crit", number(f.of_critical)},
            {"Turning point", length_words(f.turn_r, style)},
            {"Windings", number(f.windings)},
            {"g", number(g.gravity * g.doppler)},
            {"  gravity", number(g.gravity)},
            {"  Doppler", number(g.doppler)},
            {"Delay", time_words(f.delay, style)}};
}

void draw_rows(const Rows& rows, std::size_t first, std::size_t last, float x) {
    const float values = (first == 0 ? kNames : kShortNames) * ImGui::GetFontSize();
    for (std::size_t i = first; i < last; ++i) {
        ImGui::SetCursorPosX(x);
        ImGui::TextDisabled("%s", rows[i].first);
        ImGui::SameLine(x + values);
        ImGui::TextUnformatted(rows[i].second.c_str());
    }
}

// What is shown where, of the rows from the first on; in `first_column` of them, then in a second one from the second line on.
struct Layout {
    bool path, potential, beside;
    std::size_t rows, first_column;
    float side, legend_width;
};

Layout layout_in(ImVec2 room, const std::vector<LandmarkCircle>& circles, bool potential, std::size_t rows) {
    const float em = ImGui::GetFontSize(), line = ImGui::GetTextLineHeightWithSpacing(),
                space = ImGui::GetStyle().ItemSpacing.x, gap = 2.0f * ImGui::GetStyle().ItemSpacing.y;
    const auto fitted = [&](Layout layout) {
        const int charts = (layout.path ? 1 : 0) + (layout.potential ? 1 : 0);
        const float widest = (charts == 2 ? kSideOfTwo : kSide) * em;
        layout.legend_width = std::min(charts == 2 ? 2.0f * widest : widest, room.x);
        const float lines = layout.beside ? 0.0f : static_cast<float>(layout.first_column) * line;
        const float wide = room.x - (layout.beside ? kBeside * em : 0.0f);
        layout.side = std::min({widest, charts == 2 ? 0.5f * (wide - space) : wide,
                                room.y - lines - legend_height(circles, layout.legend_width) - gap});
        return layout;
    };
    const Layout all = fitted({true, potential, false, rows, potential ? 1 + rows / 2 : rows, 0, 0}),
                 beside = fitted({!potential, potential, true, rows, rows, 0, 0}),
                 charts = fitted({true, potential, false, kFewRows, kFewRows, 0, 0});
    Layout least = fitted({!potential, potential, false, kFewRows, kFewRows, 0, 0});
    const bool columns_fit = !potential || room.x >= kColumns * em;
    if (all.side >= kLeastSide * em && columns_fit) return all;
    for (const Layout& layout : {potential ? charts : beside, potential ? beside : charts})
        if (layout.side >= kLeastSide * em) return layout;
    least.side = std::max(least.side, 4.0f * em);
    return least;
}

}  // namespace

// Numbers are below the charts, in two columns below two; in a low window beside a single one.
void Probe::draw(float left, float top, float bottom, bool potential, const NumberStyle& numbers) {
    if (!facts_ || !spacetime_) return;
    const float em = ImGui::GetFontSize(), margin = 0.6f * em, right = ImGui::GetIO().DisplaySize.x - margin;
    const ImVec2 padding = ImGui::GetStyle().WindowPadding;
    const Rows rows = rows_of(*facts_, scene_, style_in(scene_, *spacetime_, numbers));
    const Layout layout =
        layout_in({right - left - margin - 2.0f * padding.x, bottom - top - 2.0f * (margin + padding.y)}, circles_,
                  potential && facts_->potential, rows.size());
    overlay("##probe", right, bottom - margin, 1.0f, 1.0f, 0.92f, [&] {
        width_ = ImGui::GetWindowWidth() + margin;
        const ImVec2 corner = ImGui::GetCursorPos();
        if (layout.potential) draw_potential(*facts_->potential, *spacetime_, circles_, layout.side);
        if (layout.potential && layout.path) ImGui::SameLine();
        if (layout.path) draw_path(*facts_, circles_, scene_, layout.side);
        draw_legend(circles_, layout.legend_width);
        if (layout.beside) ImGui::SetCursorPos({corner.x + layout.side + em, corner.y});
        draw_rows(rows, 0, layout.first_column, ImGui::GetCursorPosX());
        if (layout.first_column == layout.rows) return;
        ImGui::SetCursorPosY(ImGui::GetCursorPosY() -
                             static_cast<float>(layout.first_column - 1) * ImGui::GetTextLineHeightWithSpacing());
        draw_rows(rows, layout.first_column, layout.rows, corner.x + kFirstColumn * em);
    });
}

const Panel kProbePanel{
    .menu = "View",
    .name = "Ray of a pixel",
    .keys = "P",
    .key = GLFW_KEY_P,
    .words = "the ray under the cursor",
    .where = Panel::Where::kCorner,
    .hides_picture = true,
    .draw =
        [](PanelPlace& place) {
            place.parts.probe.draw(place.left, place.top, place.bottom - place.gap, place.view.show_potential,
                                   place.view.numbers);
        },
};

}  // namespace nullscope::viewer
