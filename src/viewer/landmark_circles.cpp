#include "viewer/landmark_circles.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "observer/critical_light.h"
#include "observer/landmarks.h"
#include "observer/spin_frame.h"
#include "spacetime/axial_metric.h"
#include "viewer/critical_overlay.h"

namespace nullscope::viewer {
namespace {

constexpr ImU32 kLabelGround = IM_COL32(126, 134, 152, 255), kErgosphere = IM_COL32(255, 128, 150, 255),
                kIsco = IM_COL32(190, 150, 255, 255);

float small() { return 0.85f * ImGui::GetFontSize(); }
float line_height() { return 1.35f * small(); }

// Calls place(circle, x, line) for each, from the top left.
template <class Place>
int in_lines(const std::vector<LandmarkCircle>& circles, float width, const Place& place) {
    const float sample = 1.3f * small(), gap = 0.9f * small();
    float x = 0.0f;
    int line = 0;
    for (const LandmarkCircle& circle : circles) {
        const float wide = sample + ImGui::CalcTextSize(circle.name).x * small() / ImGui::GetFontSize();
        if (x > 0.0f && x + wide > width) x = 0.0f, ++line;
        place(circle, x, line);
        x += wide + gap;
    }
    return circles.empty() ? 0 : line + 1;
}

}  // namespace

std::vector<LandmarkCircle> landmark_circles(const Spacetime& spacetime) {
    std::vector<LandmarkCircle> found;
    const auto add = [&](const char* name, const std::optional<double>& r, unsigned colour, bool filled) {
        if (r) found.push_back({name, *r, spacetime.areal_radius(*r), colour, filled});
    };
    const Landmarks marks = landmarks_of(spacetime);
    add("surface", spacetime.surface_radius(), kLabelGround, true);
    add(marks.singular ? "singularity" : "horizon", marks.horizon, kLabelGround, true);
    if (const AxialMetric* metric = spacetime.axial())
        add("ergosphere", static_limit(*metric, 0.5 * std::numbers::pi), kErgosphere, false);
    if (const auto sphere = open_photon_sphere(spacetime))
        add("photon orbit", sphere->radius, kCriticalColour, false);
    else if (spacetime.rotates())
        add("photon orbit", marks.photon_orbit, kCriticalColour, false);
    add("ISCO", marks.isco, kIsco, false);
    std::ranges::stable_sort(found, {}, &LandmarkCircle::areal);
    return found;
}

void draw_circles(const std::vector<LandmarkCircle>& circles, float middle_x, float middle_y, float scale) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 middle{middle_x, middle_y};
    for (const LandmarkCircle& circle : circles) {
        const float radius = scale * static_cast<float>(circle.areal);
        if (circle.filled) draw.AddCircleFilled(middle, radius, (circle.colour & 0x00ffffffu) | 0x70000000u, 64);
        draw.AddCircle(middle, radius, circle.colour, 96, 1.2f);
    }
}

float legend_height(const std::vector<LandmarkCircle>& circles, float width) {
    return line_height() * static_cast<float>(in_lines(circles, width, [](auto&&...) {}));
}

void draw_legend(const std::vector<LandmarkCircle>& circles, float width) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImU32 ink = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    const int lines = in_lines(circles, width, [&](const LandmarkCircle& circle, float x, int line) {
        const ImVec2 at{corner.x + x, corner.y + line_height() * static_cast<float>(line)};
        draw.AddCircle({at.x + 0.45f * small(), at.y + 0.55f * small()}, 0.36f * small(), circle.colour, 24, 1.5f);
        draw.AddText(ImGui::GetFont(), small(), {at.x + 1.3f * small(), at.y}, ink, circle.name);
    });
    ImGui::Dummy({width, line_height() * static_cast<float>(lines)});
}

}  // namespace nullscope::viewer
