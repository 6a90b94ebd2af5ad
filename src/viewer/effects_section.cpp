#include "viewer/effects_section.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>

#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

std::string time_of(const EffectTimes& times, Effect effect) {
    for (const EffectTime& time : times.effects)
        if (time.effect == effect) return fmt::format("{:.1f} ms", time.ms);
    return times.complete ? "" : "...";
}

void right_aligned(const std::string& text) {
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(text.c_str()).x);
    ImGui::TextDisabled("%s", text.c_str());
}

}  // namespace

bool effects_section(ViewState& view, const EffectsPanel& panel) {
    bool changed = false;
    const EffectSet drawn = effects_of(panel.drawn);
    for (const EffectReason& reason : required_effects(view.scene)) {
        const EffectRow& row = effect_row(reason.effect);
        const std::string key(row.key);
        const bool alone = without_effect(view.scene, reason.effect).has_value();
        bool on = !view.off.contains(reason.effect);
        if (alone) {
            if (ImGui::Checkbox(key.c_str(), &on)) {
                on ? view.off.erase(reason.effect) : view.off.insert(reason.effect);
                changed = true;
            }
        } else {
            ImGui::AlignTextToFramePadding();
            ImGui::Indent(ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x);
            ImGui::TextUnformatted(key.c_str());
            ImGui::Unindent(ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x);
        }
        tooltip(fmt::format("{}\nHere because of {}.\nCosts {}.", row.help, reason.reason, row.cost).c_str());
        right_aligned(!on                              ? "off"
                      : !drawn.contains(reason.effect) ? "not called for"
                      : alone                          ? time_of(panel.times, reason.effect)
                                                       : "");
    }
    const std::string picture =
        panel.times.picture_ms > 0.0 ? fmt::format("{:.1f} ms the whole picture; ", panel.times.picture_ms) : "";
    paragraph(
        fmt::format("{}beside each effect what the picture takes more than without it. {} {} compiled in {:.0f} ms{}.",
                    picture, panel.programs, panel.programs == 1 ? "program" : "programs", panel.compile_ms,
                    panel.background ? "" : ", while the window waits"),
        ImGuiCol_TextDisabled);
    return changed;
}

}  // namespace nullscope::viewer
