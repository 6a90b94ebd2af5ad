// Zooms into the photon ring as drawn: the shader core's rays, and a number in every pixel, at any depth.
#include <algorithm>
#include <cmath>

#include "render/frame_tables.h"
#include "scenefile/scene_file.h"
#include "support/gpu_session.h"

using namespace nullscope;
using namespace nullscope::test;

namespace {

Scene zoom_of(const char* name, double depth, double angle) {
    auto scene = load_scene(name);
    REQUIRE(scene);
    scene->camera.width = 160, scene->camera.height = 90;
    scene->camera.zoom = ZoomSpec{depth, angle};
    return *scene;
}

}  // namespace

TEST_CASE("ring view: rays on the GPU are those of the shader core, at rest and in motion") {
    constexpr double kOff_px = 0.02;  // of a float, at 100 px from the critical curve; measured: 2e-3
    on_every_context([&](GpuSession& session) {
        for (const double depth : {0.0, 9.0, 30.0, 300.0})
            for (const Vec3 velocity : {Vec3{}, Vec3{0.2, -0.3, 0.5}}) {
                Scene scene = zoom_of("photon-ring", depth, 2.0);
                scene.camera.velocity = velocity;
                CAPTURE(depth);
                const RayFrame drawn = gl_ray_data(session, scene);
                const CoreInput input = session.renderer->tables().core_input();
                double worst = 0;
                int on_disc = 0, elsewhere = 0;
                for (int y = 0; y < 90; y += 3)
                    for (int x = 0; x < 160; x += 3) {
                        const auto core = [&](double dx) { return trace_core64(input, x + 0.5 - 80 + dx, 44.5 - y); };
                        const RayPixel gl = drawn.at(x, y), here = core(0), beside = core(0.01);
                        if (gl.fate != here.fate || gl.hit != here.hit) ++elsewhere;
                        if (gl.hit != kDiscHit || here.hit != kDiscHit || beside.hit != kDiscHit) continue;
                        const double moves = std::hypot(beside.u - here.u, beside.v - here.v) / 0.01;
                        worst = std::max(worst, std::hypot(gl.u - here.u, gl.v - here.v) / std::max(moves, 1e-6));
                        ++on_disc;
                    }
                CHECK(on_disc > 10);
                CHECK(elsewhere <= 3);
                CHECK(worst < kOff_px);
            }
    });
}

TEST_CASE("ring view: every pixel of a picture is a number, however deep") {
    on_every_context([](GpuSession& session) {
        for (double depth = 4; depth < by_depth(8.0, 30.0, 60.0); depth += by_depth(3.0, 1.0, 0.1)) {
            Scene scene = zoom_of("accretion", depth, 0.0);
            // Few rays are so close to the curve that something overflows: edges have many.
            scene.camera.width = 1280, scene.camera.height = 720;
            scene.picture.bloom = 0;
            CAPTURE(depth);
            REQUIRE(session.renderer->prepare(scene));
            const Image<float> picture = session.renderer->picture();
            const std::size_t count = static_cast<std::size_t>(picture.width) * picture.height * picture.channels;
            CHECK(std::all_of(picture.at(0, 0), picture.at(0, 0) + count, [](float v) { return std::isfinite(v); }));
        }
    });
}
