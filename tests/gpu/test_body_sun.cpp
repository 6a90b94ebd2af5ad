// Bodies lit by a far sun: the shader's light against the reference's, pixel by pixel.
#include <algorithm>
#include <cmath>

#include "base/assets.h"
#include "reference/reference.h"
#include "support/gpu_session.h"

using namespace nullscope;

namespace {

Body plain(BodyShape shape) {
    Body body;
    body.shape = std::move(shape);
    body.material.texture = TextureKind::kPlain;
    body.material.night = 0.1, body.material.sun_longitude = 1.1, body.material.sun_latitude = 0.4;
    return body;
}

Scene lit(const std::string& metric) {
    Scene scene;
    scene.spacetime.metric = metric;
    if (metric == "kerr") scene.spacetime.parameters = {{"spin", 0.7}}, scene.camera.observer = ObserverKind::kZamo;
    scene.camera.r = 20, scene.camera.theta = 1.3;
    scene.camera.width = 96, scene.camera.height = 54;
    scene.camera.plane_width = 1.0;
    scene.sky.kind = SkyKind::kBlack;
    scene.picture.refine = false;
    BallSpec ball;
    ball.position = {-4, 4, 1}, ball.radius = 2;
    CylinderSpec cylinder;
    cylinder.inner = 5, cylinder.outer = 7, cylinder.height = 0.5;
    scene.bodies = {plain(ball), plain(cylinder)};
    return scene;
}

TEST_CASE("body sun: the light of bodies lit by a far sun is the reference's" * test::costly()) {
    constexpr double kLight = 2e-3;  // of colours up to 1: in flat coordinates a float's place
    constexpr double kEdges = 0.12;  // of the lit pixels: rims are covered in part, in the reference's one ray not
    for (const char* metric : {"schwarzschild", "kerr", "minkowski"}) {
        CAPTURE(std::string(metric));
        const Scene scene = lit(metric);
        const auto sky = build_sky(scene.sky, assets_directory(), 256);
        REQUIRE(sky);
        const auto exact = reference::render_frame(scene, *sky, {}, 1);
        REQUIRE(exact);
        test::on_every_context([&](test::GpuSession& session) {
            REQUIRE(session.renderer->prepare(scene));
            const Image<float> picture = session.renderer->picture();
            int lit_pixels = 0, off = 0, dark = 0;
            for (std::size_t i = 0; i < picture.data.size(); i += 3) {
                if (exact->data[i] <= 0) continue;
                ++lit_pixels;
                dark += exact->data[i] < 0.15F;
                off += !(std::abs(picture.data[i] - exact->data[i]) <= kLight);
            }
            fmt::print("{}: {}: {} of {} pixels off by more than {}, {} of them on the night's side\n",
                       session.context->kind(), metric, off, lit_pixels, kLight, dark);
            CHECK(lit_pixels > 200);
            CHECK(dark > 20);
            CHECK(off <= kEdges * lit_pixels);
        });
    }
}

}  // namespace
