// A camera that is let go in the viewer: its clock, a hand that takes part, the end.
#include <doctest/doctest.h>

#include <cmath>

#include "studio/fall.h"
#include "support/costly.h"

namespace {

using namespace nullscope;
using viewer::Fall;

Scene camera_scene(double r, ObserverKind observer = ObserverKind::kStatic) {
    Scene scene;
    scene.camera.r = r, scene.camera.observer = observer;
    return scene;
}

TEST_CASE("fall: a clock that runs, stops, is turned back, and ends") {
    Scene scene = camera_scene(5.0);
    Fall fall;
    CHECK_FALSE(fall.active());
    CHECK_FALSE(fall.step(scene, 1.0));
    REQUIRE(fall.let_go(scene));
    CHECK(fall.runs());
    CHECK(fall.step(scene, 1.0));
    CHECK(scene.camera.r < 5.0);
    const double r = scene.camera.r, tau = fall.tau();
    fall.run(false);
    CHECK_FALSE(fall.step(scene, 1.0));
    fall.seek(scene, 0.0);
    CHECK(std::fabs(scene.camera.r - 5.0) < 1e-9);
    fall.seek(scene, tau);
    CHECK(scene.camera.r == doctest::Approx(r));
    fall.run(true);
    for (int i = 0; i < 100 && fall.runs(); ++i) fall.step(scene, 1.0);
    CHECK_FALSE(fall.runs());
    CHECK(scene.camera.r < 0.01);  // 35.124 M = 17.562 r_s/c from rest at 10 M
    CHECK(fall.tau() == doctest::Approx(17.562).epsilon(1e-3));
    fall.stop();
    CHECK(fall.rate() == Fall().rate());
}

TEST_CASE("fall: who turns the camera lets it fall on from there") {
    Scene scene = camera_scene(3.0, ObserverKind::kRain);
    Fall fall;
    REQUIRE(fall.let_go(scene));
    fall.step(scene, 0.5);
    const double r = scene.camera.r;
    scene.camera.yaw += 0.3;
    const double yaw = scene.camera.yaw;
    CHECK(fall.step(scene, 1e-6));
    CHECK(std::fabs(scene.camera.yaw - yaw) < 1e-4);
    CHECK(std::fabs(scene.camera.r - r) < 1e-4);
    CHECK(fall.tau() < 1e-3);
    CHECK(fall.runs());
}

TEST_CASE("fall: from anywhere it takes 20 s, the end of it slowly, also for who turns meanwhile" * test::costly()) {
    constexpr double kStep_s = 1.0 / 16;
    for (const ObserverKind observer : {ObserverKind::kStatic, ObserverKind::kRain})
        for (const double r : {2.0, 10.0, 300.0, 1e4, 1e6, 1e9})
            for (const bool turns : {false, true}) {
                CAPTURE(r);
                Scene scene = camera_scene(r, observer);
                Fall fall;
                REQUIRE(fall.let_go(scene));
                double passed_s = 0.0, inside_s = 0.0;
                for (; fall.runs() && passed_s < 60.0; passed_s += kStep_s) {
                    CHECK(fall.step(scene, kStep_s));
                    if (turns) scene.camera.yaw += 0.01;
                    if (scene.camera.r < 1.0) inside_s += kStep_s;
                }
                CHECK_FALSE(fall.runs());
                CHECK(std::fabs(passed_s - 20.0) < (turns ? 1.0 : 2 * kStep_s));
                CHECK(inside_s > 0.9);
                CHECK(fall.rate() < 0.26);
            }
}

TEST_CASE("fall: an orbit stays an orbit") {
    Scene scene = camera_scene(6.0, ObserverKind::kOrbit);
    Fall fall;
    REQUIRE(fall.let_go(scene));
    fall.haste = 50.0;
    for (int i = 0; i < 20; ++i) fall.step(scene, 1.0);
    CHECK(std::fabs(scene.camera.r - 6.0) < 1e-6);
}

TEST_CASE("fall: about a rotating hole the clock runs through the horizon and ends short of the inner one") {
    Scene scene = camera_scene(2.0, ObserverKind::kZamo);
    scene.spacetime = {"kerr", {{"spin", 0.9}}};
    scene.camera.velocity = {-0.2, 0, 0};
    Fall fall;
    REQUIRE(fall.let_go(scene));
    REQUIRE(fall.line().horizon_time());
    CHECK(fall.line().end() == WorldlineEnd::kSurface);
    fall.haste = 1e4;
    CHECK(fall.step(scene, 1.0));
    CHECK_FALSE(fall.runs());
    CHECK(scene.camera.observer == ObserverKind::kRain);
    CHECK(scene.camera.r < 0.7179);  // the outer horizon
    CHECK(scene.camera.r > 0.2821);  // the inner one
}

}  // namespace
