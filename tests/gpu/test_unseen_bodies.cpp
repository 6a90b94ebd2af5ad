// Bodies that move next to a horizon: rays traced back stay above it for ever, and what moves there is not seen (plan/moving.h).
#include <fmt/format.h>

#include <cmath>

#include "support/costly.h"
#include "support/medium_pictures.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

Scene hole_scene(const char* metric, double spin) {
    Scene scene = bare_scene(metric, spin);
    scene.camera.r = 11, scene.camera.theta = 1.2, scene.camera.phi = 0.35, scene.camera.plane_width = 1.5;
    scene.camera.width = 48, scene.camera.height = 27;
    return scene;
}

BallSpec falling(Vec3 position, double radius, Vec3 velocity) {
    return {position, radius, BallMotion::kGeodesic, velocity};
}

BallSpec crossing(double radius) {  // it is within the hole about t = -40
    return {{0, 4, 0}, radius, BallMotion::kPath, {}, "0", "4 + 0.1*t", "0"};
}

Scene with(Scene scene, BodyShape shape, double time) {
    scene.bodies.push_back({std::move(shape)});
    scene.bodies.back().material.colour = {1, 1, 1};
    scene.time = time;
    return scene;
}

}  // namespace

TEST_CASE("unseen: bodies next to a horizon are the reference's" * test::costly()) {
    constexpr double kFlux =
        0.06;  // edges are covered in part here, and not in the reference: a third of the pixels of small images
    constexpr double kFate = 0.006;  // of the pixels, whose light is another by half of it
    on_every_context([&](GpuSession& session) {
        const SurfaceSpec solid{.shape = "length(x, y - 4 - 0.1*t, z) - 1", .bound = 6};
        const SphereSpec pulse{1.4, 0.4, 20};
        const Scene at_rest = hole_scene("schwarzschild", 0), turning = hole_scene("kerr", 0.9);
        Selection selection(2);
        for (const auto& [name, scene] :
             {std::pair{"came out of it", with(at_rest, falling({4.6, -3.2, 0.9}, 1.5, {0.1, 0, 0.2}), 7)},
              {"falls", with(at_rest, falling({6, 0, 0}, 1, {0, 0, 0}), 40)},
              {"through the hole", with(at_rest, crossing(1), 0)},
              {"through one that turns", with(turning, crossing(1), 0)},
              {"solid", with(at_rest, solid, 0)},
              {"solid about one that turns", with(turning, solid, 0)},
              {"pulse", with(at_rest, pulse, 0)},
              {"pulse about one that turns", with(turning, pulse, 0)}}) {
            if (selection.takes_next()) held(session, fmt::format("unseen, {}", name), scene, {kFlux, 0.5, kFate});
        }
    });
}

TEST_CASE("unseen: a ball that falls is seen no more in the end" * test::costly()) {
    on_every_context([&](GpuSession& session) {
        double before = INFINITY;
        for (const double time : {0.0, 30.0, 45.0, 120.0}) {
            const double light = sum_of(
                picture_of(session, with(hole_scene("schwarzschild", 0), falling({6, 0, 0}, 0.5, {0, 0, 0}), time)));
            CAPTURE(time);
            CHECK(light <= 1.5 * before);
            before = light;
        }
        CHECK(before == 0.0);
    });
}
