#include "viewer/ring_zoom.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "observer/critical_light.h"
#include "observer/ring_view.h"
#include "reference/frame_tracer.h"
#include "studio/view_state.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

// Of the critical direction that is nearest to where the camera looks.
double nearest_angle(const Spacetime& spacetime, const Scene& scene) {
    const auto critical = CriticalLight::make(spacetime, scene.camera, scene.light);
    if (!critical) return 0.0;
    constexpr int kDirections = 720;
    double nearest = 0.0, most = -2.0;
    for (int i = 0; i < kDirections; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kDirections, ahead = -critical->direction(angle).z;
        if (ahead > most) most = ahead, nearest = angle;
    }
    return nearest;
}

// Half turns of the light at this place of the picture; about a rotating hole its crossings of the equatorial plane.
int image_order(const reference::FrameTracer& tracer, double x, double y) {
    constexpr int kMost = 1000;
    if (tracer.plane_rays() != nullptr) return tracer.pixel(x, y, false).order;
    return static_cast<int>(tracer.ray(x, y)->crossings(kMost).size());
}

}  // namespace

bool zoom_by(Scene& scene, double depth, std::string& error) {
    const auto spacetime = spacetime_of(scene);
    if (spacetime == nullptr) return false;
    Scene zoomed = scene;
    ZoomSpec& zoom = zoomed.camera.zoom ? *zoomed.camera.zoom
                                        : zoomed.camera.zoom.emplace(ZoomSpec{0.0, nearest_angle(*spacetime, scene)});
    zoom.depth = std::min(zoom.depth + depth, kDeepestZoom);
    const auto view = ring_view(*spacetime, zoomed.camera, zoomed.light);
    if (!view) return error = view.error().message(), false;
    error.clear();
    if (zoom.depth < 0.0) {
        if (!scene.camera.zoom) return false;  // it does not begin by going back
        zoom.depth = 0.0;
        if (const auto plain = without_zoom(*spacetime, zoomed.camera, zoomed.light)) scene.camera = *plain;
        return true;
    }
    scene = std::move(zoomed);
    return true;
}

void zoom_along(Scene& scene, double right, double up) {
    constexpr double kBeside = 1e-6;  // rad of the ring
    const auto spacetime = spacetime_of(scene);
    if (spacetime == nullptr) return;
    ZoomSpec& zoom = *scene.camera.zoom;
    const auto view = ring_view(*spacetime, scene.camera, scene.light);
    if (!view) return;
    const auto critical = CriticalLight::make(*spacetime, view->camera, scene.light);
    if (!critical) return;
    const Vec3 way =
        (critical->direction(zoom.angle + kBeside) - critical->direction(zoom.angle - kBeside)) / (2.0 * kBeside);
    const double pixel = scene.camera.pixel();
    const double length2 = way.x * way.x + way.y * way.y;
    zoom.angle = std::remainder(zoom.angle - pixel * (right * way.x + up * way.y) / length2, 2.0 * std::numbers::pi);
}

std::string zoom_words(const Scene& scene) {
    if (!scene.camera.zoom) return {};
    const double power = scene.camera.zoom->depth / std::numbers::ln10;
    std::string words =
        power < 3.0 ? fmt::format("zoom {:.3g}", std::pow(10.0, power)) : fmt::format("zoom 10^{:.1f}", power);
    const auto spacetime = spacetime_of(scene);
    const auto view = spacetime != nullptr ? ring_view(*spacetime, scene.camera, scene.light)
                                           : Result<RingView>(bad_input("no spacetime"));
    if (!view) return words;
    Scene plain = scene;
    plain.camera = view->camera;
    plain.disc.reset(), plain.spots.clear(), plain.bodies.clear(), plain.medium.reset();
    if (spacetime->rotates()) plain.disc.emplace();  // image_order(): the reference then counts crossings
    const auto tracer = reference::FrameTracer::make(plain);
    if (!tracer) return words;
    const double w = plain.camera.width, h = plain.camera.height;
    int order = 0;
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {w, 0.0}, {0.0, h}, {w, h}})
        order = std::max(order, image_order(*tracer, x, y));
    return fmt::format("{}, image order {}", words, order + 2 * static_cast<int>(view->turns));
}

void draw_zoom_overlay(const std::string& words, float left, float right, float top) {
    const float width = ImGui::CalcTextSize(words.c_str()).x + 2.0f * ImGui::GetStyle().WindowPadding.x;
    if (words.empty() || width > right - left) return;
    overlay("##zoom", left, top, 0.0f, 0.0f, 0.9f, [&] { ImGui::TextUnformatted(words.c_str()); });
}

}  // namespace nullscope::viewer
