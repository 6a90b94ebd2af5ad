// Cameras about a rotating hole that do more than rest, outside its horizon, on it and inside: rays against the reference, and next to
// no spin the pictures of the table.
#include <algorithm>
#include <cmath>

#include "observer/observer.h"
#include "spacetime/registry.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kKerrObserversRays_px = 0.05;  // what is promised of every ray, px of 1080p
const int kKerrObserversWidth = by_depth(64, 96, 96), kKerrObserversHeight = by_depth(36, 54, 54);
const double kFiner = 1920.0 / kKerrObserversWidth;

struct View {
    ObserverKind observer;
    double spin, r, theta, yaw, fov;
    Vec3 velocity{};
};

Scene scene_of(const View& view, bool disc) {
    Scene scene;
    scene.spacetime = {"kerr", {{"spin", view.spin}}};
    CameraSpec& camera = scene.camera;
    camera.observer = view.observer;
    camera.r = view.r, camera.theta = view.theta, camera.phi = 0.7, camera.yaw = view.yaw,
    camera.velocity = view.velocity;
    camera.fall_from = 6, camera.energy = 1.5;
    camera.plane_width = 2 * std::tan(view.fov / 2), camera.width = kKerrObserversWidth,
    camera.height = kKerrObserversHeight;
    if (disc) scene.disc.emplace(), scene.disc->inner = 1.0, scene.disc->outer = 7.0;
    return scene;
}

TEST_CASE("kerr observers: every one's frame is the reference's, outside, on and inside the horizon" * test::costly()) {
    using enum ObserverKind;
    const double outer = *(*make_spacetime("kerr", {{"spin", 0.9}}))->horizon_radius();
    const View views[] = {{kStatic, 0.9, 3, 1.3, 0.3, 1.6},
                          {kStatic, 0.998, 1.2, 1.0, 1.5, 1.9},
                          {kCarter, 0.9, 0.9, 1.2, 2, 1.9},
                          {kOrbit, 0.9, 1.17, M_PI / 2, 1, 2},
                          {kOrbit, 0.998, 4, 1.1, 0.02, 1.2},
                          {kCounterOrbit, 0.9, 4.5, M_PI / 2, 0.2, 1.2},
                          {kRain, 0.9, 3, 1.3, 0.4, 1.6},
                          {kRain, 0.9, 1.0, 1.2, 1.6, 2},
                          {kRain, 0.9, outer * (1 + 1e-6), 1.2, 1.6, 2},
                          {kRain, 0.9, outer, 1.2, 2, 2},
                          {kRain, 0.9, outer * (1 - 1e-6), 1.2, 2.4, 2},
                          {kRain, 0.9, 0.5, 0, 3, 2},
                          {kRain, 0.9, 0.3, 1.5, 2.6, 2},
                          {kRain, 0.998, 0.5, 1.2, 2.6, 2},
                          {kRain, 0.3, 0.1, 0.8, 2, 2},
                          {kRain, 0.5, 0.2, 0.8, 2, 2},
                          {kRain, 0.1, 0.4, 1.5, 2.6, 2},
                          {kRain, 0.9, 0.29, 1.5, 0.5, 2},
                          {kFall, 0.7, 2, 1.2, 0, 1.6},
                          {kFall, 0.7, 0.6, 2, 2, 2},
                          {kThrow, 0.9, 0.6, 1.2, 2.2, 2},
                          {kRain, 0.9, 0.6, 1.2, 2, 2, {0.3, -0.2, 0.5}},
                          {kRain, 0.9, 1.5, 1.2, 0.5, 2, {-0.6, 0.1, 0.2}},
                          {kOrbit, 0.9, 3, 1.4, 0.5, 2, {0.2, 0.1, 0}},
                          {kRain, 0.9999, 0.6, 1.2, 2, 2},
                          {kThrow, 0.95, 30, 1.2, 0, 0.6}};
    on_one_context([&](GpuSession& session) {
        Selection selection(7);  // odd: with and without the disc
        for (const View& view : views)
            for (const bool disc : {false, true}) {
                if (!selection.takes_next()) continue;
                const Scene scene = scene_of(view, disc);
                const RayMeasures m = measure_rays(gl_ray_data(session, scene), scene.camera, reference_trace(scene));
                fmt::print(
                    "{:<13} a = {:<6} r = {:<8.6g} {:<4}: sky {:.4f}, disc {:.4f}, g {:.4f} px of 1080p; fate errors "
                    "{}, skies {}\n",
                    observer_name(view.observer), view.spin, view.r, disc ? "disc" : "sky", m.sky_px.max * kFiner,
                    m.place_px.max * kFiner, m.g_px.max * kFiner, m.fate_errors, m.sky_px.count);
                CHECK(m.sky_px.max * kFiner <= kKerrObserversRays_px);
                CHECK(m.place_px.max * kFiner <= kKerrObserversRays_px);
                CHECK(m.fate_errors == 0);
                CHECK(m.not_finite == 0);
            }
    });
}

// Of the sky's directions in two frames, px of 1080p: where it turns fast with the pixel, of as much less.
struct Apart {
    double most_px = 0;
    int fates = 0, skies = 0;
};
Apart apart(const RayFrame& one, const RayFrame& other, const CameraSpec& camera) {
    Apart result;
    const double pixel = camera.plane_width / 1920;
    for (int y = 1; y + 1 < one.height; ++y)
        for (int x = 1; x + 1 < one.width; ++x) {
            const RayPixel &a = one.at(x, y), &b = other.at(x, y), &right = one.at(x + 1, y), &down = one.at(x, y + 1);
            result.fates += a.fate != b.fate;
            if (a.fate != Fate::kEscaped || b.fate != a.fate || right.fate != a.fate || down.fate != a.fate) continue;
            const double sway = std::max(
                {length(right.sky - a.sky) / (kFiner * pixel), length(down.sky - a.sky) / (kFiner * pixel), 1.0});
            result.most_px = std::max(result.most_px, length(a.sky - b.sky) / sway / pixel);
            ++result.skies;
        }
    return result;
}

TEST_CASE("kerr observers: next to no spin each sees what the table shows it without" * test::costly()) {
    using enum ObserverKind;
    const View views[] = {{kStatic, 0, 3, 1.3, 0.3, 1.6}, {kCarter, 0, 3, 1.3, 0.3, 1.6},
                          {kOrbit, 0, 4, 1.1, 0.5, 1.6},  {kCounterOrbit, 0, 4, 1.1, 0.5, 1.6},
                          {kRain, 0, 3, 1.3, 1, 1.6},     {kRain, 0, 0.6, 1.2, 2, 2},
                          {kFall, 0, 0.4, 1.2, 2, 2},     {kThrow, 0, 1.2, 1.2, 1, 1.6},
                          {kFall, 0, 2, 0.5, 1, 1.6},     {kRain, 0, 0.6, 1.2, 2, 2, {0.3, -0.2, 0.5}}};
    on_one_context([&](GpuSession& session) {
        for (View view : views) {
            Scene scene = scene_of(view, false);
            const RayFrame table = gl_ray_data(session, scene);
            view.spin = 1e-9;
            const Apart near = apart(table, gl_ray_data(session, scene_of(view, false)), scene.camera);
            view.spin = 0.1;
            const Apart far = apart(table, gl_ray_data(session, scene_of(view, false)), scene.camera);
            fmt::print(
                "{:<13} r = {:<4}: spin 1e-9 against the table {:.4f} px of 1080p over {} skies, {} fates; spin 0.1 "
                "{:.1f} px\n",
                observer_name(view.observer), view.r, near.most_px, near.skies, near.fates, far.most_px);
            CHECK(near.most_px <= kKerrObserversRays_px);
            CHECK(near.fates == 0);
            CHECK(near.skies > by_depth(200, 500, 500));
            CHECK(far.most_px > kKerrObserversRays_px);  // the check can fail
        }
    });
}

}  // namespace
