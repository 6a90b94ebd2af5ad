#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "base/text.h"
#include "studio/number_words.h"
#include "viewer/sections.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr double kLeastAsked_px = 1e-4, kMostAsked_px = 10.0;

bool method_row(ViewState& view, const FrameFacts& facts, bool escape) {
    MethodWish& wish = view.method;
    row("Method", "How rays are traced. auto: the fastest method whose measured error stays below Max error.");
    const std::string shown = wish.automatic ? "auto" : method_name(wish.method);
    bool changed = false;
    choice("##method", shown, escape, [&] {
        if (choice_item("auto", wish.automatic)) changed = !std::exchange(wish.automatic, true);
        for (const MeasuredMethod& measured : facts.measured) {
            if (measured.metric != view.scene.spacetime.metric) continue;
            const std::string help = fmt::format("At most {:.2g} px in this frame, {:.2f} times flat space.",
                                                 error_in_frame(measured, view.scene), measured.floor_ratio);
            if (!choice_item(method_name(measured.method), !wish.automatic && wish.method == measured.method, help))
                continue;
            wish.automatic = false;
            wish.method = measured.method;
            changed = true;
        }
    });
    return changed;
}

bool shaders_row(StageWish& wish, bool escape) {
    struct Kind {
        StageWish wish;
        const char *name, *help;
    };
    constexpr Kind kKinds[] = {{StageWish::kAuto, "auto", "What takes less, timed once for each kind of scene."},
                               {StageWish::kFragment, "fragment", "Of every OpenGL."},
                               {StageWish::kCompute, "compute", "Needs OpenGL 4.3."}};
    row("Shaders",
        "What traces pictures: fragment or compute shaders. The picture is the same. auto times both when such a scene "
        "is first at rest, except where the processor draws.");
    const auto now = std::ranges::find(kKinds, wish, &Kind::wish);
    bool changed = false;
    choice("##shaders", (now == std::end(kKinds) ? kKinds[0] : *now).name, escape, [&] {
        for (const Kind& kind : kKinds)
            if (choice_item(kind.name, wish == kind.wish, kind.help) && wish != kind.wish)
                wish = kind.wish, changed = true;
    });
    return changed;
}

bool asked_row(MethodWish& wish) {
    double decades = std::log10(wish.max_error_px);
    if (!slide_as("Max error", decades, std::log10(kLeastAsked_px), std::log10(kMostAsked_px),
                  fmt::format("{:.2g} px", wish.max_error_px),
                  "The largest error that auto may make, in pixels of this frame."))
        return false;
    // What is shown is what is asked.
    const auto rounded = parse_number(fmt::format("{:.2g}", std::pow(10.0, decades)));
    return rounded && *rounded != std::exchange(wish.max_error_px, *rounded);
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

std::string state_of(const AccuracyFacts& facts) {
    if (!facts.error.empty()) return facts.error;
    if (facts.of_this_frame)
        return facts.errors.complete() ? "This frame is measured completely" : "Measuring this frame";
    return facts.errors.measured > 0 ? "From an earlier frame (this one moves)" : "Measured when the picture is still";
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
    paragraph(state_of(facts));
    values("Error in px",
           "Screen error: how many pixels the camera ray would have to move for its result, a direction on the sky or "
           "a place on the disc, to be exact.",
           "sky", disc ? "disc" : "", ImGuiCol_TextDisabled);
    errors("max", "Largest of the pixels measured so far.", &Spread::max);
    errors("99.9 %", "99.9 % of the pixels measured so far are at or below this.", &Spread::p999);
    errors("median", "Half of the pixels measured so far are at or below this.", &Spread::median);
    values("Fate errors",
           "Pixels whose ray ends elsewhere (sky, hole, disc) than the exact ray, beyond 0.01 px (0.05 px at the "
           "disc's rims) of the edge.",
           e.measured > 0 ? count_words(e.fate_errors) : "-", "", colour);
    const std::string share = e.complete() ? "all" : fmt::format("{:.0f} %", std::floor(e.percent()));
    values("Rays", "Pixels measured so far: every 64th in both directions, then every 16th, 8th and 4th, then all.",
           e.pixels > 0 ? fmt::format("{}, {}", count_words(e.measured), share) : "-", "", colour);
}

}  // namespace

bool accuracy_section(ViewState& view, const FrameFacts& facts, bool escape) {
    if (most_exact(facts.measured, view.scene.spacetime.metric) != nullptr) draw_frontier_plot(view, facts);
    bool changed = false;
    if (facts.not_measured.empty()) {
        changed = method_row(view, facts, escape);
        changed |= asked_row(view.method);
        paragraph(facts.choice.words, !facts.choice.kept);
    } else {
        paragraph(facts.not_measured, true);
    }
    changed |= shaders_row(view.stage, escape);
    if (!facts.stage_words.empty()) paragraph("Shaders: " + facts.stage_words);
    row("Overlay",
        "Shows the screen error of every pixel as a colour over the picture: the larger of sky and disc (key H).");
    ImGui::Checkbox("Error of every pixel", &view.show_errors);
    ImGui::Separator();
    measured_rows(facts.accuracy, view.scene.disc.has_value());
    values("Frame time",
           "Time of the last picture, without panels. A measurement running at the same time slows it down.",
           fmt::format("{:.1f} ms", facts.picture_ms));
    return changed;
}

}  // namespace nullscope::viewer
