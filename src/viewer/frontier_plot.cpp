#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "viewer/sections.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr const char* kHelp =
    "Every measured method: its largest screen error on the sky, scaled to this frame, against its cost. Ring: the "
    "method in use. Diamond: the true error of this frame on the sky. Grey: another method is at least as accurate and "
    "as fast.";

// A logarithmic axis: decades to positions on the screen.
struct Axis {
    double low, high;
    float from, to;
    float at(double value) const {
        const double part = std::clamp((std::log10(value) - low) / (high - low), 0.0, 1.0);
        return from + static_cast<float>(part) * (to - from);
    }
};

std::string power(int decade) {
    return decade >= 0 && decade <= 2 ? fmt::format("{:g}", std::pow(10.0, decade)) : fmt::format("1e{}", decade);
}

class Plot {
public:
    Plot(const ViewState& view, const FrameFacts& facts)
        : scene_(view.scene), facts_(facts), draw_(*ImGui::GetWindowDrawList()) {
        if (view.method.automatic) asked_px_ = view.method.max_error_px;
        const Spread& errors = facts.accuracy.errors.sky_px;
        if (facts.accuracy.of_this_frame && errors.count > 0) true_px_ = errors.max;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x, height = 10.5f * em_;
        double c1 = 10.0, e0 = 1e-4, e1 = 1.0;  // at least what can be asked for
        const auto widen = [&](double error) {
            if (std::isfinite(error) && error > 0.0) e0 = std::min(e0, error), e1 = std::max(e1, error);
        };
        for (const MeasuredMethod& row : facts.measured) {
            if (row.metric != scene_.spacetime.metric) continue;
            rows_.push_back(&row);
            c1 = std::max(c1, row.floor_ratio);
            widen(error_of(row));
        }
        for (const auto& error : {asked_px_, true_px_}) widen(error.value_or(0.0));
        x_ = {0.0, std::log10(1.3 * c1), at.x + 2.4f * em_, at.x + width - 0.3f * em_};
        y_ = {std::floor(std::log10(e0)), std::ceil(std::log10(e1)), at.y + height - 2.3f * small_,
              at.y + 1.4f * small_};
        ImGui::InvisibleButton("##plot", {width, height});
        hovered_ = ImGui::IsItemHovered();
    }

    void grid() const {
        const ImU32 ink = ImGui::GetColorU32(ImGuiCol_TextDisabled);
        draw_.AddRectFilled({x_.from, y_.to}, {x_.to, y_.from}, packed(palette().text.with(0.03f)));
        for (int d = 0; d <= x_.high; ++d) {
            const float x = x_.at(std::pow(10.0, d));
            draw_.AddLine({x, y_.to}, {x, y_.from}, packed(palette().text.with(0.08f)));
            text(x, y_.from + 0.15f * small_, power(d), d == 0 ? 0.0f : 0.5f, ink);
        }
        const int decades = static_cast<int>(y_.high - y_.low), every = decades > 5 ? 2 : 1;
        for (int d = static_cast<int>(y_.low); d <= y_.high; d += every) {
            const float y = y_.at(std::pow(10.0, d));
            draw_.AddLine({x_.from, y}, {x_.to, y}, packed(palette().text.with(0.08f)));
            text(x_.from - 0.35f * em_, y - 0.5f * small_, power(d), 1.0f, ink);
        }
        text(x_.from, y_.to - 1.3f * small_, "error in px of this frame", 0.0f, ink);
        text(x_.to, y_.from + 1.15f * small_, "cost, times flat space", 1.0f, ink);
    }

    void points() {
        if (asked_px_) {
            const float y = y_.at(*asked_px_);
            draw_.AddLine({x_.from, y}, {x_.to, y}, packed(palette().accent.with(0.5f)));
            text(x_.to - 0.3f * small_, y - 1.15f * small_, "max error", 1.0f, packed(palette().accent));
        }
        for (const MeasuredMethod* row : rows_) {
            const ImVec2 at = place_of(*row);
            const bool dominated = is_dominated(*row, facts_.measured);
            draw_.AddCircleFilled(at, (dominated ? 0.16f : 0.2f) * em_,
                                  packed(dominated ? palette().dim.with(0.6f) : palette().accent));
            near(at,
                 fmt::format("{}{}\nat most {:.2g} px in this frame\n{:.2f} times flat space", method_name(row->method),
                             dominated ? ", dominated" : ", on the frontier", error_of(*row), row->floor_ratio));
        }
        const MeasuredMethod* now = row_of(facts_.measured, facts_.choice.method, scene_.spacetime.metric);
        if (now != nullptr) marks(*now);
        if (hovered_) tooltip(nearest_.empty() ? kHelp : nearest_);
    }

private:
    double error_of(const MeasuredMethod& row) const { return error_in_frame(row, scene_); }
    ImVec2 place_of(const MeasuredMethod& row) const { return {x_.at(row.floor_ratio), y_.at(error_of(row))}; }

    // The method of the frame, and down from it what the frame was measured to err.
    void marks(const MeasuredMethod& row) {
        const float half = 0.3f * em_;
        const ImVec2 at = place_of(row);
        draw_.AddCircle(at, 0.42f * em_, packed(palette().accent), 24, 1.5f);
        if (!true_px_ || !(*true_px_ > 0.0)) return;
        const bool over = !std::isfinite(*true_px_);
        const ImVec2 truth{at.x, over ? y_.to : y_.at(*true_px_)};
        draw_.AddLine(at, truth, packed(palette().measured.with(0.5f)), 1.5f);
        draw_.AddQuadFilled({truth.x - half, truth.y}, {truth.x, truth.y - half}, {truth.x + half, truth.y},
                            {truth.x, truth.y + half}, packed(palette().measured));
        near(truth, fmt::format("this frame, measured:\nat most {:.2g} px on the sky", *true_px_));
    }

    void near(ImVec2 at, const std::string& words) {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const float distance = std::hypot(mouse.x - at.x, mouse.y - at.y);
        if (distance > std::min(nearest_px_, 0.7f * em_)) return;
        nearest_px_ = distance;
        nearest_ = words;
    }

    // align: 0 begins, 1 ends at x.
    void text(float x, float y, const std::string& words, float align, ImU32 colour) const {
        const float length = ImGui::CalcTextSize(words.c_str()).x * small_ / em_;
        draw_.AddText(ImGui::GetFont(), small_, {x - align * length, y}, colour, words.c_str());
    }

    const Scene& scene_;
    const FrameFacts& facts_;
    std::optional<double> asked_px_, true_px_;  // a line across; what was measured of the frame itself
    ImDrawList& draw_;
    Axis x_{}, y_{};
    std::vector<const MeasuredMethod*> rows_;  // of the frame's metric
    const float em_ = ImGui::GetFontSize(), small_ = 0.8f * em_;
    float nearest_px_ = 1e9f;
    bool hovered_ = false;
    std::string nearest_;
};

}  // namespace

void draw_frontier_plot(const ViewState& view, const FrameFacts& facts) {
    Plot plot(view, facts);
    plot.grid();
    plot.points();
}

}  // namespace nullscope::viewer
