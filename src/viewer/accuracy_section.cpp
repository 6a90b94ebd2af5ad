#include "viewer/accuracy_section.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"
#include "viewer/frontier_plot.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr double kLeastAsked_px = 1e-4, kMostAsked_px = 10.0;

bool method_row(ViewState& view, const AccuracyPanel& panel, bool escape) {
    MethodWish& wish = view.method;
    row("Method", "How rays are traced. auto: the cheapest that was measured to keep the largest error below.");
    const std::string shown = wish.automatic ? "auto" : method_name(wish.method);
    if (!begin_choice("##method", shown, escape)) return false;
    bool changed = false;
    if (choice_item("auto", wish.automatic)) changed = !std::exchange(wish.automatic, true);
    for (const MeasuredMethod& measured : panel.measured) {
        if (measured.metric != view.scene.spacetime.metric) continue;
        const std::string help = fmt::format("At most {:.2g} px in this frame, {:.2f} times flat space.",
                                             error_in_frame(measured, view.scene), measured.floor_ratio);
        if (!choice_item(method_name(measured.method), !wish.automatic && wish.method == measured.method, help))
            continue;
        wish.automatic = false;
        wish.method = measured.method;
        changed = true;
    }
    end_choice();
    return changed;
}

bool asked_row(MethodWish& wish) {
    row("Max error", "The largest error that auto may make, in pixels of this frame.");
    double decades = std::log10(wish.max_error_px);
    if (!slide_as("##asked", decades, std::log10(kLeastAsked_px), std::log10(kMostAsked_px), 0,
                  fmt::format("{:.2g} px", wish.max_error_px)))
        return false;
    const auto rounded =
        parse_number(fmt::format("{:.2g}", std::pow(10.0, decades)));  // what is shown is what is asked
    if (!rounded || *rounded == wish.max_error_px) return false;
    wish.max_error_px = *rounded;
    return true;
}

void refusal(const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, {1.0f, 0.52f, 0.45f, 1.0f});
    paragraph(text, ImGuiCol_Text);
    ImGui::PopStyleColor();
}

// A row of values that begin at the columns of the table.
void values(const char* name, const char* help, const std::string& first, const std::string& second = {},
            int colour = ImGuiCol_Text) {
    text_row(name, help);
    const float left = ImGui::GetCursorPosX(), column = 0.5f * ImGui::GetContentRegionAvail().x;
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(colour));
    ImGui::TextUnformatted(first.c_str());
    if (!second.empty()) {
        ImGui::SameLine(left + column);
        ImGui::TextUnformatted(second.c_str());
    }
    ImGui::PopStyleColor();
}

std::string thousands(long long number) {
    std::string text = fmt::format("{}", number);
    for (std::size_t at = text.size(); at > 3; at -= 3)
        text.insert(text.begin() + static_cast<std::ptrdiff_t>(at) - 3, ' ');
    return text;
}

std::string state_of(const AccuracyFacts& facts) {
    if (!facts.error.empty()) return facts.error;
    if (facts.of_this_frame) return facts.measuring ? "Measuring this frame" : "All of this frame is measured";
    return facts.errors.measured > 0 ? "Of an earlier frame: this one moves" : "Measured when the picture rests";
}

void measured_rows(const AccuracyFacts& facts, bool disc) {
    const ErrorSummary& e = facts.errors;
    const int colour = facts.of_this_frame ? ImGuiCol_Text : ImGuiCol_TextDisabled;
    const auto px = [](const Spread& spread, double error) {
        return spread.count > 0 ? fmt::format("{:.2g}", error) : std::string("-");
    };
    const auto errors = [&](const char* name, const char* help, double Spread::*which) {
        values(name, help, px(e.sky_px, e.sky_px.*which), disc ? px(e.place_px, e.place_px.*which) : "", colour);
    };
    paragraph(state_of(facts), ImGuiCol_TextDisabled);
    values("Error in px",
           "Screen error: by how many pixels a camera ray would have to move for its answer, a direction on the sky or "
           "a place "
           "on the disc, to be exact.",
           "sky", disc ? "disc" : "", ImGuiCol_TextDisabled);
    errors("max", "Of the pixels measured so far.", &Spread::max);
    errors("99.9 %", "So many of the pixels measured so far are not worse.", &Spread::p999);
    errors("median", "Half of the pixels measured so far are not worse.", &Spread::median);
    values("Fate errors",
           "Pixels that end elsewhere than the exact ray, further than 0.01 px (0.05 px at the disc's rims) from where "
           "the "
           "exact ray ends alike.",
           e.measured > 0 ? thousands(e.fate_errors) : "-", "", colour);
    const std::string share = e.complete() ? "all" : fmt::format("{:.0f} %", std::floor(e.percent()));
    values("Rays", "Pixels measured so far: every 16th each way, then every 8th and 4th, then all.",
           e.pixels > 0 ? fmt::format("{}, {}", thousands(e.measured), share) : "-", "", colour);
}

}  // namespace

bool accuracy_section(ViewState& view, const AccuracyPanel& panel, bool escape) {
    const bool lensed = std::any_of(panel.measured.begin(), panel.measured.end(), [&](const MeasuredMethod& measured) {
        return measured.metric == view.scene.spacetime.metric;
    });
    const AccuracyFacts& facts = panel.facts;
    if (lensed) {
        FrontierPlot plot{panel.measured, view.scene, panel.choice.method, {}, {}};
        if (view.method.automatic) plot.asked_px = view.method.max_error_px;
        if (facts.of_this_frame && facts.errors.sky_px.count > 0) plot.true_px = facts.errors.sky_px.max;
        draw_frontier_plot(plot);
    }
    bool changed = false;
    if (panel.not_measured.empty()) {
        changed = method_row(view, panel, escape);
        changed = asked_row(view.method) || changed;
    }
    if (!panel.not_measured.empty() || !panel.choice.kept)
        refusal(panel.not_measured.empty() ? panel.choice.words : panel.not_measured);
    else
        paragraph(panel.choice.words, ImGuiCol_TextDisabled);
    row("Overlay", "The screen error of every pixel over the picture, by colour: the larger of sky and disc. Key H.");
    ImGui::Checkbox("Error of every pixel", &view.show_errors);
    ImGui::Separator();
    measured_rows(facts, view.scene.disc.has_value());
    values("Frame time", "Of the picture drawn last, without panels. A measurement that runs beside it slows it.",
           fmt::format("{:.1f} ms", panel.picture_ms));
    return changed;
}

}  // namespace nullscope::viewer
