#include <fmt/format.h>
#include <imgui.h>

#include <string>

#include "viewer/sections.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

std::string time_of(const EffectTimes& times, Effect effect) {
    if (const auto found = times.effects.find(effect); found != times.effects.end())
        return fmt::format("{:.1f} ms", found->second);
    return times.complete ? "" : "...";
}

void right_aligned(const std::string& text) {
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(text.c_str()).x);
    ImGui::TextDisabled("%s", text.c_str());
}

}  // namespace

bool effects_section(ViewState& view, const FrameFacts& facts) {
    bool changed = false;
    const EffectSet drawn = effect_set(required_effects(facts.painting.job.scene));
    for (const EffectReason& reason : required_effects(view.scene)) {
        const EffectRow& row = effect_row(reason.effect);
        const std::string key(row.key);
        const bool alone = without_effect(view.scene, reason.effect).has_value();
        bool on = !view.off.contains(reason.effect);
        if (!alone) {
            const float box = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
            ImGui::AlignTextToFramePadding();
            ImGui::SetCursorPosX(ImGui::GetCursorPosX() + box);
            ImGui::TextUnformatted(key.c_str());
        } else if (ImGui::Checkbox(key.c_str(), &on)) {
            on ? view.off.erase(reason.effect) : view.off.insert(reason.effect);
            changed = true;
        }
        tooltip(fmt::format("{}\nNeeded because of {}.\nCost: {}.", row.help, reason.reason, row.cost));
        right_aligned(!on                              ? "off"
                      : !drawn.contains(reason.effect) ? "not needed"
                      : alone                          ? time_of(facts.times, reason.effect)
                                                       : "");
    }
    const std::string picture =
        facts.times.picture_ms > 0.0 ? fmt::format("{:.1f} ms for the whole picture; ", facts.times.picture_ms) : "";
    paragraph(fmt::format("{}for each effect: time with it minus time without it. {} {} compiled in {:.0f} ms{}.",
                          picture, facts.painting.programs, facts.painting.programs == 1 ? "program" : "programs",
                          facts.painting.compile_ms, facts.background ? "" : ", while the window waits"));
    return changed;
}

}  // namespace nullscope::viewer
