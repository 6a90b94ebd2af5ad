// Zooms into the photon ring as drawn: the shader core's rays, and a number in every pixel, at any depth.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "render/frame_tables.h"
#include "scenefile/scene_file.h"
#include "support/gpu_session.h"
#include "support/paired_cost.h"

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

TEST_CASE("ring view: every pixel of a picture is a number, however deep" * test::costly()) {
    on_one_context([](GpuSession& session) {
        for (double depth = 4; depth < by_depth(8.0, 30.0, 60.0); depth += by_depth(3.0, 2.0, 0.1)) {
            Scene scene = zoom_of("accretion", depth, 0.0);
            // Few rays are so close to the curve that something overflows: edges have many.
            scene.camera.width = 1280, scene.camera.height = 720;
            scene.picture.bloom = 0;
            CAPTURE(depth);
            const Image<float> picture = picture_of(session, scene);
            const std::size_t count = static_cast<std::size_t>(picture.width) * picture.height * picture.channels;
            CHECK(std::all_of(picture.at(0, 0), picture.at(0, 0) + count, [](float v) { return std::isfinite(v); }));
        }
    });
}

TEST_CASE("ring view: the film of zoom ends where it began" * test::costly()) {
    on_every_context([](GpuSession& session) {
        auto scene = load_scene("zoom");
        REQUIRE(scene);
        scene->camera.width = 320, scene->camera.height = 180;
        std::vector<Image<unsigned char>> ends;
        for (const double turns : {0.0, 1.0}) {
            scene->camera.zoom->depth = scene->path->keys[turns > 0 ? 1 : 0].camera.zoom->depth;
            REQUIRE(session.renderer->prepare(*scene));
            ends.push_back(session.renderer->picture8());
        }
        int worst = 0;
        for (int y = 0; y < 180; ++y)
            for (int i = 0; i < 3 * 320; ++i)
                worst = std::max(worst, std::abs(ends[0].at(0, y)[i] - ends[1].at(0, y)[i]));
        CHECK(worst <= 1);
    });
}

// A frame at 10^-100 over one at e^-1, of so many rows over 180.
PairedCost cost_of_depth(int pairs, int rows) {
    auto session = open_gpu("egl");
    REQUIRE(session);
    Renderer shallow;
    const gl::Target target = gl::make_target(1280, 360, gl::Format::kRgba8);
    const auto prepare = [](Renderer& renderer, double depth, int height) {
        Scene scene = zoom_of("photon-ring", depth, 2.0);
        scene.camera.width = 1280, scene.camera.height = height;
        renderer.refine(false);
        REQUIRE(renderer.prepare(scene));
    };
    prepare(*session->renderer, 100 * M_LN10, rows), prepare(shallow, 1, 180);
    const auto draw = [&](Renderer& by, int height) {
        by.draw(target.framebuffer.id(), 1280, height, Output::kDisplay);
    };
    const auto at_depth = [&] { draw(*session->renderer, rows); };
    const auto near = [&] { draw(shallow, 180); };
    at_depth(), near();  // compiles
    const PairedCost cost = paired_cost(pairs, at_depth, near);
    fmt::print(
        "zoom: a frame of {} rows at 10^-100 {:.4f} core-s, one of 180 at e^-1 {:.4f}, ratio {:.3f} ({:.3f} to "
        "{:.3f})\n",
        rows, cost.first_s, cost.second_s, cost.ratio, cost.low, cost.high);
    return cost;
}

TEST_CASE("ring view: depth costs nothing" * test::costly()) {
    constexpr double kMost = 1.2;
    const int pairs = by_depth(9, 15, 21);
    CHECK(within(kMost, [&] { return cost_of_depth(pairs, 180); }).low <= kMost);
    CHECK(cost_of_depth(pairs, 270).ratio > kMost);  // that the check can fail
}
