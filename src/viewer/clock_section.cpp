// The scene's clock: what moves goes on, stops, and is turned back; and whether its light takes time.
#include <fmt/format.h>
#include <imgui.h>

#include <cmath>

#include "scene/moving.h"
#include "viewer/sections.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {

// The camera's own time beside it: of one at rest sqrt(A) of the clocks at infinity.
bool clock_section(ViewState& view) {
    constexpr double kSpan = 1e4;  // r_s/c that the slider covers
    Scene& scene = view.scene;
    bool changed = false;
    if (moving_parts(scene).empty()) {
        paragraph("Nothing in this scene changes with time.", ImGuiCol_TextDisabled);
        return false;
    }
    const float width = (ImGui::GetContentRegionAvail().x - 2.0f * ImGui::GetStyle().ItemSpacing.x) / 3.0f;
    if (ImGui::Button(view.clock_runs ? "Pause" : "Run", {width, 0.0f})) view.clock_runs = !view.clock_runs;
    tooltip("The scene's clock: t at the camera.");
    for (const auto& [name, sign] : {std::pair{"Step back", -1.0}, {"Step", 1.0}}) {
        ImGui::SameLine();
        if (!ImGui::Button(name, {width, 0.0f})) continue;
        view.clock_runs = false;
        scene.time += sign * kClockStep_s * view.clock_rate;
        changed = true;
    }
    tooltip("A tenth of a second of yours at this rate.");
    row("Rate", "r_s/c a second of yours.");
    slide_as("##clock rate", view.clock_rate, 1e-2, 1e3, ImGuiSliderFlags_Logarithmic,
             fmt::format("{:.3g} r_s/c a second", view.clock_rate));
    row("Time", "Slide to go there.");
    if (slide_as("##time", scene.time, 0.0, kSpan, ImGuiSliderFlags_Logarithmic,
                 fmt::format("{:.3f} r_s/c", scene.time))) {
        view.clock_runs = false;
        changed = true;
    }
    changed = tick("Delay", scene.light.delay,
                   "What moves is seen where it was when its light left; else where it is now.") ||
              changed;
    const auto spacetime = spacetime_of(scene);
    if (spacetime != nullptr && scene.camera.observer == ObserverKind::kStatic &&
        spacetime->lapse_squared(scene.camera.r) > 0.0)
        paragraph(fmt::format("The camera's own clock shows {:.3f} r_s/c.",
                              std::sqrt(spacetime->lapse_squared(scene.camera.r)) * scene.time),
                  ImGuiCol_TextDisabled);
    return changed;
}

bool step_clock(ViewState& view, double dt_s) {
    if (!view.clock_runs || view.fall.runs() || moving_parts(view.scene).empty()) return false;
    view.scene.time += dt_s * view.clock_rate;
    return true;
}

}  // namespace nullscope::viewer
