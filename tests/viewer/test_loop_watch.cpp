// Which orbit the panel of Q and U asks for, and what it keeps of the answers.
#include <cmath>

#include <doctest/doctest.h>

#include "scene/spot_orbit.h"
#include "studio/loop_watch.h"

namespace {

using namespace nullscope;
using namespace nullscope::viewer;

Scene spot_scene() {
    Scene scene;
    scene.disc.emplace();
    scene.disc->emission = DiscEmission::kThermal;
    scene.disc->outer = 10.0;
    scene.disc->polarisation.by = Polarisation::kSynchrotron;
    scene.spots.emplace_back().r = 5.0;
    scene.camera.width = 320, scene.camera.height = 200;
    scene.time = 150.0;
    return scene;
}

// Q = the point's number, to the given one.
StokesLoop first_points(int count) {
    StokesLoop loop;
    for (int i = 0; i < count; ++i) loop.push_back({0.0, 1.0, static_cast<double>(i), 0.0});
    return loop;
}

}  // namespace

TEST_CASE("loop watch: the order is one orbit of the spot, of a small picture of all that is seen") {
    const Scene scene = spot_scene();
    const LoopOrder order = loop_order(scene);
    CHECK(order.period == doctest::Approx(2 * M_PI * std::sqrt(2 * 125.0)).epsilon(1e-9));  // Kepler's, r_s = 2 M
    CHECK(order.from == doctest::Approx(order.period));
    CHECK(order.time(0) == order.from);
    CHECK(order.time(LoopOrder::kPoints - 1) == doctest::Approx(2 * order.period));
    CHECK(order.scene.camera.width == 96);
    CHECK(order.scene.camera.height == 60);
    CHECK(order.scene.camera.pixel_aspect == doctest::Approx(scene.camera.pixel_aspect));
    Scene narrow = scene;
    narrow.camera.width = 1000, narrow.camera.height = 3;
    const CameraSpec small = loop_order(narrow).scene.camera;
    CHECK(small.height == 1);
    CHECK(small.pixel_aspect * 96 / 1 ==
          doctest::Approx(narrow.camera.pixel_aspect * 1000 / 3));  // of the whole picture
}

TEST_CASE("loop watch: scenes without a loop say why") {
    CHECK(no_loop(spot_scene()).empty());
    Scene plain = spot_scene();
    plain.disc->polarisation.by = Polarisation::kOff;
    CHECK(no_loop(plain).find("disc.polarisation") != std::string::npos);
    Scene still = spot_scene();
    still.spots.clear();
    CHECK(no_loop(still).find("[spot]") != std::string::npos);
    LoopWatch watch;
    watch.look(still, true);
    CHECK_FALSE(watch.take_order());
    CHECK_FALSE(watch.waits());
}

TEST_CASE("loop watch: time alone asks for nothing within an orbit, and keeps the loop for the next one") {
    Scene scene = spot_scene();
    LoopWatch watch;
    watch.look(scene, true);
    CHECK(watch.take_order());
    CHECK_FALSE(watch.take_order());
    watch.take(first_points(20));
    CHECK(watch.waits());
    CHECK(watch.loop().size() == 20);
    CHECK_FALSE(watch.present());
    watch.take(first_points(LoopOrder::kPoints));
    CHECK_FALSE(watch.waits());
    const double period = *spot_period(scene);
    scene.time = 1.25 * period;
    watch.look(scene, false);
    CHECK_FALSE(watch.take_order());
    CHECK(watch.present()->q == doctest::Approx(30.0));
    scene.time = 2.125 * period;
    watch.look(scene, false);
    CHECK(watch.take_order()->from == doctest::Approx(2 * period));
    watch.take(first_points(5));
    CHECK(watch.loop().size() == LoopOrder::kPoints);
    CHECK(watch.present()->q == doctest::Approx(15.0));
}

TEST_CASE("loop watch: another view is asked for when it rests, and answers of the last one are not taken") {
    Scene scene = spot_scene();
    LoopWatch watch;
    watch.look(scene, true);
    CHECK(watch.take_order());
    watch.take(first_points(LoopOrder::kPoints));
    scene.camera.theta = 0.3;
    watch.look(scene, false);
    CHECK_FALSE(watch.take_order());
    CHECK(watch.loop().size() == LoopOrder::kPoints);
    CHECK_FALSE(watch.present());
    watch.look(scene, true);
    CHECK(watch.loop().empty());
    watch.take(first_points(3));
    CHECK(watch.loop().empty());
    CHECK(watch.take_order());
    watch.take(first_points(3));
    CHECK(watch.found() == 3);
}
