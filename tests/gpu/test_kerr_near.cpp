// Cameras next to the horizon of a rotating hole, fast ones and slow ones: float's digits are not lost there (shaders/mino/near.glsl).
#include <algorithm>
#include <cmath>

#include "observer/spin_forms.h"
#include "spacetime/registry.h"
#include "support/gpu_session.h"

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

Scene near_scene(const NearView& view) {
    Scene scene;
    scene.spacetime = {"kerr", {{"spin", view.spin}}};
    if (view.charge > 0) scene.spacetime = {"kerr-newman", {{"spin", view.spin}, {"charge", view.charge}}};
    CameraSpec& camera = scene.camera;
    camera.observer = ObserverKind::kZamo;
    camera.r = view.horizons * *(*make_spacetime(scene.spacetime.metric, scene.spacetime.parameters))->horizon_radius();
    camera.theta = view.theta * M_PI / 180, camera.yaw = view.yaw * M_PI / 180, camera.velocity = view.velocity;
    camera.plane_width = 2, camera.width = kNearWidth, camera.height = kNearHeight;
    scene.sky.kind = SkyKind::kGrid;
    return scene;
}

// Errors are looked for from this on, px of this frame.
RayMeasures near_measures(GpuSession& session, const Scene& scene) {
    constexpr double kRefine_px = 0.1 * kNearRays_px * kNearWidth / 3840;
    return measure_rays(gl_ray_data(session, scene), scene.camera, reference_trace(scene), 1, kRefine_px);
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
    on_one_context([&](GpuSession& session) {
        for (const NearView& view : views) {
            const Scene scene = near_scene(view);
            const RayMeasures m = near_measures(session, scene);
            CHECK(session.renderer->tables().effects().contains(Effect::kSpinNear));
            constexpr double kFiner4K = 3840.0 / kNearWidth;
            fmt::print(
                "a = {:<6} Q = {:<4} r = {:<6} r_+ v = ({}, {}, {}) yaw {:<3}: sky {:.4f}, {:.4f}, {:.5f} px of 4K; "
                "fate "
                "errors {}, skies {}\n",
                view.spin, view.charge, view.horizons, view.velocity.x, view.velocity.y, view.velocity.z, view.yaw,
                m.sky_px.max * kFiner4K, m.sky_px.p999 * kFiner4K, m.sky_px.median * kFiner4K, m.fate_errors,
                m.sky_px.count);
            CHECK(m.sky_px.count > 0);
            CHECK(m.sky_px.max * kFiner4K <= kNearRays_px);
            CHECK(m.fate_errors == 0);
            CHECK(m.not_finite == 0);
        }
    });
}

TEST_CASE("kerr near: the disc that such a camera sees, falling cameras, and where the effect begins" *
          test::costly()) {
    on_one_context([&](GpuSession& session) {
        constexpr double kFiner4K = 3840.0 / kNearWidth, kPlace_px = 0.1;  // 56 without the effect
        Scene disc = near_scene({0.9995, 0, 1.02, {0, 0, 0.99}, 90});
        disc.disc.emplace(), disc.disc->inner = 0.53, disc.disc->outer = 15;
        const RayMeasures places = near_measures(session, disc);
        fmt::print("disc: {:.4f}, {:.4f} px of 4K of {}\n", places.place_px.max * kFiner4K,
                   places.place_px.p999 * kFiner4K, places.place_px.count);
        CHECK(places.place_px.count > 500);
        CHECK(places.place_px.max * kFiner4K <= kPlace_px);
        CHECK(places.fate_errors == 0);
        Scene rain = near_scene({0.9995, 0, 1.02});
        rain.camera.observer = ObserverKind::kRain;
        const RayMeasures skies = near_measures(session, rain);
        CHECK(session.renderer->tables().effects().contains(Effect::kSpinFall));
        CHECK(session.renderer->tables().effects().contains(Effect::kSpinNear));
        fmt::print("rain: {:.4f} px of 4K\n", skies.sky_px.max * kFiner4K);
        CHECK(skies.sky_px.max * kFiner4K <= kNearRays_px);
        for (const double horizons : {2.49, 2.51}) {  // 1 - r_+/r = 0.6 lies between them
            const Scene scene = near_scene({0.9995, 0, horizons, {0, 0, 0.99}, 0});
            const RayMeasures m = near_measures(session, scene);
            CHECK(session.renderer->tables().effects().contains(Effect::kSpinNear) == (horizons < 2.5));
            fmt::print("r = {} r_+: {:.4f} px of 4K\n", horizons, m.sky_px.max * kFiner4K);
            CHECK(m.sky_px.max * kFiner4K <= kNearRays_px);
        }
    });
}

// With pixels small beside the critical curve `spin-ring` is on as well: in a wide view it has no peak from the host, and leaves rays alone.
TEST_CASE("kerr near: a wide view with pixels so small that it is next to the critical curve") {
    on_one_context([&](GpuSession& session) {
        Scene scene = near_scene({0.9, 0, 1.2, {0, 0, 0.9}, 0});
        scene.camera.width = 192, scene.camera.height = 108;
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
