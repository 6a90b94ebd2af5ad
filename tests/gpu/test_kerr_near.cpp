// Cameras next to the horizon of a rotating hole, fast ones and slow ones: float's digits are not lost there (shaders/mino/near.glsl).
#include <algorithm>
#include <cmath>

#include "against_reference.h"
#include "spacetime/registry.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kNearRays_px = 0.02;  // of a 4K frame over 90 degrees
constexpr int kNearWidth = 64, kNearHeight = 36;

struct NearView {
    double spin, charge, horizons;  // a/M, Q/M, r over r_+
    Vec3 velocity{};
    double yaw = 180, theta = 80;  // degrees
};

Draft near_scene(const NearView& view) {
    Draft draft;
    if (view.charge > 0)
        draft.metric("kerr-newman", {{"spin", view.spin}, {"charge", view.charge}});
    else
        draft.metric("kerr", {{"spin", view.spin}});
    const auto& [metric, parameters] = draft.scene.spacetime;
    const double r = view.horizons * *(*make_spacetime(metric, parameters))->horizon_radius();
    return draft.place(r, view.theta * M_PI / 180)
        .yaw(view.yaw * M_PI / 180)
        .by(ObserverKind::kZamo)
        .moving(view.velocity)
        .plane(2)
        .size(kNearWidth, kNearHeight)
        .sky(SkyKind::kGrid);
}

Promise near_promise(double sky_px, double place_px = kNotHeld) {  // px of 4K; errors are looked for from a tenth on
    return {
        .sky = sky_px, .place = place_px, .of_width = 3840, .refine_above_px = 0.1 * kNearRays_px * kNearWidth / 3840};
}

TEST_CASE("kerr near: fast and slow cameras next to the horizon are the reference's to 0.02 px of 4K" *
          test::costly()) {
    // docs/accuracy.md, "Cameras next to a rotating horizon".
    const NearView views[] = {{0.9, 0, 1.02},
                              {0.9995, 0, 1.02},
                              {0.9995, 0, 1.003},
                              {0.9, 0, 1.003, {-0.9, 0, 0}},
                              {0.97, 0, 1.2, {0, 0, 0.99}, 0},
                              {0.9, 0, 1.2, {0, 0, 0.9}, 0},
                              {0.9995, 0, 1.02, {0, 0, 0.99}, 0},
                              {0.9995, 0, 1.02, {0, 0, 0.99}, 90},
                              {0.9995, 0, 1.003, {-0.9, 0, 0}},
                              {0.9995, 0, 1.003, {-0.9, 0, 0}, 0},
                              {0.9998, 0, 1.0003, {-0.9, 0, 0}},
                              {0.9998, 0, 1.02, {0, 0, 0.999}, 90},
                              {0.9995, 0, 1.0001},
                              {0.9998, 0, 1.3, {0, 0, 0.99}, 0},
                              {0.01, 0, 1.002, {-0.95, 0, 0}},
                              {0.6, 0.79, 1.05, {0, 0, 0.95}, 120},
                              {0.9, 0, 1.01, {-0.99, 0, 0}},
                              {0.9995, 0, 1.02, {0, 0, 0.99}, 90, 90}};
    Promise promise = near_promise(kNearRays_px);
    promise.least_skies = 1;
    AgainstReference judge("kerr near", promise);
    on_one_context([&](GpuSession& session) {
        for (const NearView& view : views) {
            judge.frame(session,
                        fmt::format("a = {:<6} Q = {:<4} r = {:<6} r_+ v = ({}, {}, {}) yaw {}", view.spin, view.charge,
                                    view.horizons, view.velocity.x, view.velocity.y, view.velocity.z, view.yaw),
                        near_scene(view));
            CHECK(session.renderer->tables().effects().contains(Effect::kSpinNear));
        }
    });
}

TEST_CASE("kerr near: the disc that such a camera sees, falling cameras, and where the effect begins" *
          test::costly()) {
    on_one_context([&](GpuSession& session) {
        const auto on = [&](Effect effect) { return session.renderer->tables().effects().contains(effect); };
        Promise places = near_promise(kNotHeld, 0.1);  // 56 without the effect
        places.least_hits = 501;
        Promise skies = near_promise(kNearRays_px);
        skies.least_skies = 1;
        AgainstReference of_disc("kerr near", places), of_sky("kerr near", skies);
        of_disc.frame(session, "disc", near_scene({0.9995, 0, 1.02, {0, 0, 0.99}, 90}).disc(0.53, 15));
        of_sky.frame(session, "rain", near_scene({0.9995, 0, 1.02}).by(ObserverKind::kRain));
        CHECK((on(Effect::kSpinFall) && on(Effect::kSpinNear)));
        for (const double horizons : {2.49, 2.51}) {  // 1 - r_+/r = 0.6 lies between them
            of_sky.frame(session, fmt::format("r = {} r_+", horizons),
                         near_scene({0.9995, 0, horizons, {0, 0, 0.99}, 0}));
            CHECK(on(Effect::kSpinNear) == (horizons < 2.5));
        }
    });
}

// With pixels small beside the critical curve `spin-ring` is on as well: in a wide view it has no peak from the host, and leaves rays alone.
TEST_CASE("kerr near: a wide view with pixels so small that it is next to the critical curve") {
    on_one_context([&](GpuSession& session) {
        const Scene scene = near_scene({0.9, 0, 1.2, {0, 0, 0.9}, 0}).size(192, 108);
        const RayFrame drawn = gl_ray_data(session, scene);
        const EffectSet& effects = session.renderer->tables().effects();
        CHECK((effects.contains(Effect::kSpinNear) && effects.contains(Effect::kSpinRing)));
        constexpr double kFiner4K = 3840.0 / 192;
        double most_px = 0;
        const TileErrors tile =
            measure_tiles(drawn, scene.camera, reference_trace(scene), {{54, 44, 78, 66}}, 1e-4).front();
        for (const PixelErrors& pixel : tile.pixels) {
            CHECK(pixel.end != RayEnd::kDiffers);
            most_px = std::max(most_px, pixel.sky_px * kFiner4K);
        }
        fmt::print("beside the curve: {:.4f} px of 4K\n", most_px);  // 4.8 with a peak that the shader formed
        CHECK(most_px > 0);
        CHECK(most_px <= kNearRays_px);
    });
}

}  // namespace
