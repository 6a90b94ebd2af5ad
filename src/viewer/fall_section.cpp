// Letting go: the camera falls, on a clock that can be stopped, hurried and turned back.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "scene/observer.h"
#include "spacetime/spin_frame.h"
#include "spacetime/tortoise.h"
#include "viewer/sections.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

// Takes hold of the camera again: at rest or on the circular orbit, where there is one.
bool hold(ViewState& view, ObserverKind observer, const Spacetime& spacetime) {
    CameraSpec held = view.scene.camera;
    held.observer = observer;
    held.velocity = {};
    // In an ergosphere nobody is at rest; without angular momentum one can stay there.
    if (observer == ObserverKind::kStatic && !spacetime.planar_rays() && !observer_of(spacetime, held))
        held.observer = ObserverKind::kZamo;
    if (const auto possible = observer_of(spacetime, held); !possible) {
        view.error = possible.error().message;
        return false;
    }
    if (falls(view.scene.camera)) view.scene.time -= time_ahead(spacetime, held.r);  // t again
    if (spacetime.axial() != nullptr && falls(view.scene.camera))
        held.phi -= azimuth_ahead(*spacetime.axial(), held.r);  // where the far sky has it
    view.scene.camera = held;
    view.fall.stop();
    return true;
}

std::string events(const Worldline& line) {
    std::string text =
        line.horizon_time() ? fmt::format("Horizon crossed at {:.4g} r_s/c. ", *line.horizon_time()) : "";
    if (line.end() == WorldlineEnd::kSingularity)
        text += fmt::format("The worldline ends at {:.4g} r_s/c, in the singularity.", line.end_time());
    if (line.end() == WorldlineEnd::kSurface)
        text += fmt::format("It comes no further than at {:.4g} r_s/c.", line.end_time());
    return text;
}

}  // namespace

bool fall_section(ViewState& view) {
    Fall& fall = view.fall;
    const auto spacetime = spacetime_of(view.scene);
    if (spacetime == nullptr) return false;
    const float width = (ImGui::GetContentRegionAvail().x - 2.0f * ImGui::GetStyle().ItemSpacing.x) / 3.0f;
    bool changed = false;
    if (ImGui::Button(fall.runs() ? "Pause" : fall.active() ? "Go on" : "Let go", {width, 0.0f})) {
        if (fall.active() && fall.tau() < fall.line().last())
            fall.run(!fall.runs());
        else if (const Status gone = fall.let_go(view.scene); !gone)
            view.error = gone.error().message;
    }
    tooltip(
        "Nobody holds the camera any more: it follows a geodesic from here, with the velocity that it has. Its axes "
        "are gyroscopes.");
    ImGui::SameLine();
    if (ImGui::Button("Hover", {width, 0.0f})) changed = hold(view, ObserverKind::kStatic, *spacetime);
    tooltip("At rest here, outside of the horizon; in an ergosphere without angular momentum.");
    ImGui::SameLine();
    if (ImGui::Button("Orbit", {width, 0.0f})) changed = hold(view, ObserverKind::kOrbit, *spacetime);
    tooltip("On the circular geodesic of this radius, outside of the photon sphere; let go, it stays on it.");
    row("Rate", "Of the camera's own clock: r_s/c a second of yours.");
    slide_as("##rate", fall.rate, 1e-3, 1e3, ImGuiSliderFlags_Logarithmic,
             fmt::format("{:.3g} r_s/c a second", fall.rate));
    if (!fall.active()) return changed;
    row("Own time", "Of the camera since it was let go. Slide to go there.");
    double tau = fall.tau();
    if (slide_as("##tau", tau, 0.0, std::min(fall.line().last(), 1e4), 0, fmt::format("{:.4f} r_s/c", tau))) {
        fall.run(false);
        fall.seek(view.scene, tau);
        changed = true;
    }
    if (const std::string text = events(fall.line()); !text.empty()) paragraph(text, ImGuiCol_TextDisabled);
    return changed;
}

}  // namespace nullscope::viewer
