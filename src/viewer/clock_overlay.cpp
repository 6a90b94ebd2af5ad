#include "viewer/clock_overlay.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "observer/landmarks.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

using Rows = std::vector<std::pair<const char*, std::string>>;

Rows rows_of(const ViewState& view, const Spacetime& spacetime) {
    const CameraNumbers here = camera_numbers(spacetime, view.scene.camera);
    Rows rows;
    if (view.fall.active()) rows.emplace_back("tau since release", fmt::format("{:.3f} r_s/c", view.fall.tau()));
    if (here.clock_rate) rows.emplace_back("dtau/dt of the camera", fmt::format("{:.6f}", *here.clock_rate));
    rows.emplace_back("dtau/dt at rest", here.lapse ? fmt::format("{:.6f}", *here.lapse) : "none in the horizon");
    if (here.lapse && *here.lapse > 0.0)
        rows.emplace_back("g from far away, at rest", fmt::format("{:.6g}", 1.0 / *here.lapse));
    return rows;
}

}  // namespace

float draw_clock_overlay(const ViewState& view, float left, float right, float top) {
    const auto spacetime = spacetime_of(view.scene);
    const Rows rows = spacetime != nullptr ? rows_of(view, *spacetime) : Rows{};
    const float padding = ImGui::GetStyle().WindowPadding.x;
    float names = 0.0f, values = 0.0f;
    for (const auto& [name, value] : rows) {
        names = std::max(names, ImGui::CalcTextSize(name).x);
        values = std::max(values, ImGui::CalcTextSize(value.c_str()).x);
    }
    const bool beside = names + em() + values + 2.0f * padding <= right - left;
    if (rows.empty() || std::max(names, values) + 2.0f * padding > right - left) return left;
    overlay("##clock", left, top, 0.0f, 0.0f, 0.9f, [&] {
        for (const auto& [name, value] : rows) {
            ImGui::TextDisabled("%s", name);
            if (beside) ImGui::SameLine(padding + names + em());
            ImGui::TextUnformatted(value.c_str());
        }
    });
    return left + 2.0f * padding + (beside ? names + em() + values : std::max(names, values));
}

}  // namespace nullscope::viewer
