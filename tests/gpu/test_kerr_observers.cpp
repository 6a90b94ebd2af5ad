// Cameras about a rotating hole that do more than rest, outside its horizon, on it and inside: rays against the reference, and next to
// no spin the pictures of the table.
#include <cmath>

#include "against_reference.h"
#include "observer/observer.h"
#include "spacetime/registry.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

struct View {
    ObserverKind observer;
    double spin, r, theta, yaw, fov;
    Vec3 velocity{};
};

Scene scene_of(const View& view, bool disc) {
    Draft draft;
    draft.metric("kerr", {{"spin", view.spin}}).by(view.observer).place(view.r, view.theta).yaw(view.yaw);
    draft.moving(view.velocity).plane(2 * std::tan(view.fov / 2)).size(by_depth(64, 96, 96), by_depth(36, 54, 54));
    CameraSpec& camera = draft.scene.camera;
    camera.phi = 0.7, camera.fall_from = 6, camera.energy = 1.5;
    return disc ? draft.disc(1.0, 7.0) : draft;
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
    std::vector<FrameCase> cases;
    for (const View& view : views)
        for (const bool disc : {false, true})
            cases.push_back({fmt::format("{:<13} a = {:<6} r = {:<8.6g} {}", observer_name(view.observer), view.spin,
                                         view.r, disc ? "disc" : "sky"),
                             scene_of(view, disc)});
    AgainstReference judge("kerr observers", {.sky = kEveryRay_px, .place = kEveryRay_px, .of_width = 1920});
    on_one_context([&](GpuSession& session) {
        judge.frames(session, Selection(7), cases);  // odd: with and without the disc
    });
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
            CHECK(near.most_px <= kEveryRay_px);
            CHECK(near.fates == 0);
            CHECK(near.skies > by_depth(200, 500, 500));
            CHECK(far.most_px > kEveryRay_px);  // the check can fail
        }
    });
}

}  // namespace
