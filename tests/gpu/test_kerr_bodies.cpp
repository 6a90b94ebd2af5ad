// Solid bodies about a rotating hole: every pixel of many small frames against the reference, which looks for them along its own rays.
#include "against_reference.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

Draft about(double spin = 0.9) {
    return Draft()
        .metric("kerr", {{"spin", spin}})
        .sky(SkyKind::kBlack)
        .place(10, 1.3)
        .size(by_depth(65, 97, 97), by_depth(37, 55, 55));
}
Draft torus_about() { return about().surface("(length(x, y) - 4)^2 + z^2 - 0.5", 5); }

TEST_CASE("kerr bodies: hits, places and fates are the reference's at every pixel" * test::costly()) {
    using enum ObserverKind;
    const BallSpec orbiting{.position = {3, 0, 0}, .radius = 0.5, .motion = BallMotion::kOrbit};
    const std::vector<FrameCase> cases = {
        {"ball in front", about().ball({3, 1, 0.5}, 0.7)},
        {"ball behind", about().ball({-4, 0.3, 0.2}, 1.0)},
        {"ball next to the horizon, spin 0.998", about(0.998).ball({0.2, -1.0, 0}, 0.3)},
        {"ball over the pole", about().ball({0, 0, 2}, 0.6)},
        {"sphere outside of all photon orbits", about().sphere(2.5)},
        {"sphere next to the horizon", about(0.998).sphere(0.6)},
        {"thick disc", about().cylinder(3, 6, 0.4)},
        {"thick disc down to the horizon, spin 0.998", about(0.998).cylinder(0.7, 4, 0.2)},
        {"thin thick disc, from the side", about().cylinder(3, 6, 0.05).place(15, 1.5)},
        {"torus", torus_about()},
        {"torus, from the axis", torus_about().place(12, 0.01)},
        {"ball before and behind a disc", about().ball({3, 0, 1.2}, 0.8).disc(2, 7)},
        {"ball and thick disc, far camera",
         about().ball({-2, 2, 1}, 0.9).cylinder(4, 6, 0.2).place(500, 1.3).plane(0.03)},
        {"orbiting ball, light delayed", about().body(orbiting).at_time(40)},
        {"pulsing sphere, light delayed", about().body(SphereSpec{2, 0.2, 20}).at_time(3)},
        {"boosted camera, ball", about().ball({3, 1, 0.5}, 2.0).by(kZamo).moving({0.3, 0.4, -0.2})},
        {"falling camera, ball", about().ball({2.5, 1, 0.5}, 0.7).place(4, 1.3).by(kRain)},
        {"falling camera inside the horizon, ball",
         about().ball({2.5, 1, 0.5}, 0.9).place(0.6, 1.3).by(kRain).yaw(M_PI)},
        {"almost no spin", about(1e-6).ball({-3, 1, 0.5}, 0.7).cylinder(4, 6, 0.3)},
        {"camera within a moving ball, before a disc",
         about().disc(2, 7).body(BallSpec{.position = {9, 1, 0}, .radius = 4, .motion = BallMotion::kOrbit})},
        {"ball far behind the hole", about().ball({-100, 30, 1}, 10).place(50, 1.5).plane(0.4)},
    };
    AgainstReference judge("kerr bodies",
                           {.sky = kEveryRay_px, .place = kEveryRay_px, .of_width = 1920, .least_hits = 1});
    on_every_context([&](GpuSession& session) { judge.frames(session, Selection(4), cases); });
}

TEST_CASE("kerr bodies: panoramas so small that a tile is as wide as the sky show all of a sphere") {
    constexpr double kOff = 0.2;  // of one ray a pixel
    on_every_context([&](GpuSession& session) {
        const auto drawn = [&](Draft draft) {
            Scene scene = draft.place(20, 1.4).yaw(M_PI).size(48, 24).plane(2 * M_PI).sphere(6);
            scene.camera.projection = Projection::kEquirectangular;
            scene.picture.refine = false;
            REQUIRE(session.renderer->prepare(scene));
            return sum_of(session.renderer->picture());
        };
        const double still = drawn(Draft().sky(SkyKind::kBlack));
        CHECK(still > 5);
        CHECK(std::abs(drawn(about()) / still - 1) <= kOff);
    });
}

}  // namespace
