#include "viewer/critical_overlay.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <vector>

#include "observer/critical_curve.h"
#include "observer/critical_light.h"
#include "observer/ring_view.h"
#include "scene/split.h"
#include "studio/comparison.h"

namespace nullscope::viewer {
namespace {

constexpr float kCurveWidth = 1.5f, kRim = 3.5f;  // of the line, and of what parts it from a bright disc
constexpr ImU32 kRimColour = IM_COL32(0, 0, 0, 130);

// left, wide: where the scene's picture lies in the window, units of ImGui.
void draw_lines(const Scene& scene, float left, float wide) {
    const auto spacetime = spacetime_of(scene);
    if (spacetime == nullptr) return;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const double unit = static_cast<double>(wide) / scene.camera.width;  // of a pixel
    const auto camera = without_zoom(*spacetime, scene.camera, scene.light);
    if (!camera) return;  // deeper than lines can be told
    draw.PushClipRect({left, 0.0f}, {left + wide, ImGui::GetIO().DisplaySize.y}, true);
    for (const PictureLine& line : critical_curve(*spacetime, *camera, scene.light)) {
        std::vector<ImVec2> points;
        points.reserve(line.size());
        for (const auto& [x, y] : line)
            points.emplace_back(left + static_cast<float>(unit * x), static_cast<float>(unit * y));
        const int count = static_cast<int>(points.size());
        draw.AddPolyline(points.data(), count, kRimColour, ImDrawFlags_None, kRim);
        draw.AddPolyline(points.data(), count, kCriticalColour, ImDrawFlags_None, kCurveWidth);
    }
    draw.PopClipRect();
}

bool has_curve(const Scene& scene) {
    const auto spacetime = spacetime_of(scene);
    return spacetime != nullptr && CriticalLight::make(*spacetime, scene.camera, scene.light);
}

void draw_critical_curve(OverlayPlace& place) {
    const Scene& scene = place.scene;
    const float wide = ImGui::GetIO().DisplaySize.x;
    const auto both = halves(scene);
    if (!both) return draw_lines(scene, 0.0f, wide);
    const float part = wide * static_cast<float>(both->left.camera.width) / static_cast<float>(scene.camera.width);
    draw_lines(both->left, 0.0f, part);
    draw_lines(both->right, part, wide - part);
}

bool has_critical_curve(const Scene& scene) {  // in its spacetime, or in either half's
    const auto both = halves(scene);
    return both ? has_curve(both->left) || has_curve(both->right) : has_curve(scene);
}

std::string no_critical_curve(const ViewState& view) {
    const bool on_b = view.side_b != nullptr && has_critical_curve(drawn_side_b(view));
    return on_b || has_critical_curve(view.scene) ? "" : "There is no critical curve here: no photon sphere";
}

}  // namespace

const Overlay kCriticalOverlay = {"Critical curve",
                                  "K",
                                  GLFW_KEY_K,
                                  "show the critical curve",
                                  "Critical curve: directions whose light spirals to the photon sphere.",
                                  no_critical_curve,
                                  Overlay::Where::kPicture,
                                  draw_critical_curve};

}  // namespace nullscope::viewer
