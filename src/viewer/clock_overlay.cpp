#include "viewer/clock_overlay.h"

#include <imgui.h>

#include <algorithm>

#include "observer/landmarks.h"
#include "studio/number_words.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {

std::vector<ClockRow> clock_rows(const ViewState& view, const Spacetime& spacetime) {
    const CameraNumbers here = camera_numbers(spacetime, view.scene.camera);
    const NumberStyle style = style_in(view.scene, spacetime, view.numbers);
    std::vector<ClockRow> rows;
    if (view.fall.active())
        rows.push_back({"tau since release", "tau", time_words(view.fall.tau(), style),
                        "Proper time of the camera since it was released."});
    if (here.clock_rate)
        rows.push_back({"dtau/dt of the camera", "Clock", fixed_words(*here.clock_rate, style, 6),
                        "Proper time of the camera over time far away, dtau/dt."});
    rows.push_back({"dtau/dt at rest", "At rest",
                    here.lapse ? fixed_words(*here.lapse, style, 6) : "none in the horizon",
                    "Proper time over time far away, of an observer at rest here."});
    if (here.lapse && *here.lapse > 0.0)
        rows.push_back({"g from far away, at rest", "Blueshift", number_words(1.0 / *here.lapse, style),
                        "g of light from far away, seen from here at rest: frequency over that at its source."});
    return rows;
}

namespace {

void draw_clock(OverlayPlace& place) {
    const ViewState& view = place.view;
    const float left = place.left, right = place.right;
    const auto spacetime = spacetime_of(view.scene);
    const auto rows = spacetime != nullptr ? clock_rows(view, *spacetime) : std::vector<ClockRow>{};
    const float padding = ImGui::GetStyle().WindowPadding.x;
    float names = 0.0f, values = 0.0f;
    for (const ClockRow& row : rows) {
        names = std::max(names, ImGui::CalcTextSize(row.name).x);
        values = std::max(values, ImGui::CalcTextSize(row.value.c_str()).x);
    }
    const bool beside = names + em() + values + 2.0f * padding <= right - left;
    if (rows.empty() || std::max(names, values) + 2.0f * padding > right - left) return;
    overlay("##clock", left, place.top, 0.0f, 0.0f, 0.9f, [&] {
        for (const ClockRow& row : rows) {
            ImGui::TextDisabled("%s", row.name);
            if (beside) ImGui::SameLine(padding + names + em());
            ImGui::TextUnformatted(row.value.c_str());
        }
    });
    place.left += 2.0f * padding + (beside ? names + em() + values : std::max(names, values));
}

}  // namespace

const Overlay kClockOverlay = {"Clock and redshift", "", 0, "", "", nullptr, Overlay::Where::kTopLeft, draw_clock};

}  // namespace nullscope::viewer
