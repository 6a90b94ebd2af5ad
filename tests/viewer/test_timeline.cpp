// A camera path in the viewer: recorded, played, changed key by key, saved.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "scenefile/scene_file.h"
#include "scenefile/scene_writer.h"
#include "studio/timeline.h"

namespace {

using namespace nullscope;
using viewer::Timeline;

Scene shipped(const char* name) {
    auto scene = load_scene(name);
    REQUIRE(scene);
    return *scene;
}

TEST_CASE("timeline: what is recorded is played again, across an angle's end, and is a scene that can be read") {
    Scene scene = shipped("first-light");
    Timeline timeline;
    timeline.follow(scene, true);
    CHECK_FALSE(timeline.has_path());
    const CameraSpec begin = scene.camera;
    timeline.record(scene);
    // A turn of 300 degrees in 2 s, past 180 degrees, with r and the scene's clock.
    const auto camera_at = [&](double t) {
        CameraSpec camera = begin;
        const double yaw = std::numbers::pi * (-0.5 + 5.0 / 6.0 * t);
        camera.yaw = std::remainder(yaw, 2.0 * std::numbers::pi);
        camera.r = begin.r + 4.0 * t;
        return camera;
    };
    const CameraSpec first = camera_at(0.0);
    scene.camera = first;
    timeline.record(scene);
    for (int i = 1; i <= 60; ++i) {
        scene.camera = camera_at(i / 30.0);
        scene.time = i / 30.0 * 3.0;
        REQUIRE(timeline.sample(scene, 1.0 / 30.0));
    }
    REQUIRE(timeline.stop_record(scene));
    CHECK(scene.camera.r == first.r);
    CHECK(scene.time == 0.0);
    timeline.follow(scene, false);
    REQUIRE(timeline.has_path());
    CHECK(timeline.frames() == 49);
    for (const double frame : {0.0, 7.0, 24.0, 33.3, 48.0}) {
        CAPTURE(frame);
        timeline.seek(scene, frame);
        const CameraSpec wanted = camera_at(frame / 24.0);
        CHECK(scene.camera.r == doctest::Approx(wanted.r).epsilon(1e-6));
        CHECK(std::fabs(std::remainder(scene.camera.yaw - wanted.yaw, 2.0 * std::numbers::pi)) < 1e-6);
        CHECK(scene.time == doctest::Approx(frame / 24.0 * 3.0));
    }
    const Scene saved = timeline.to_save(scene);
    CHECK(saved.camera.r == first.r);
    CHECK(saved.time == 0.0);
    const auto again = parse_scene(scene_file_text(saved, {}), "again.toml", {});
    REQUIRE_MESSAGE(again, again.error().message());
    CHECK(again->path->keys.size() == scene.path->keys.size());
    CHECK(again->path->keys.back().time == doctest::Approx(6.0));
}

TEST_CASE("timeline: playing ends or loops, and a fall that ships is played") {
    Scene scene = shipped("plunge");
    const CameraSpec start = scene.camera;
    Timeline timeline;
    timeline.follow(scene, true);
    REQUIRE(timeline.has_path());
    timeline.loops = false;
    timeline.play(true);
    int steps = 0;
    while (timeline.step(scene, 0.1) && steps < 100000) ++steps;
    CHECK_FALSE(timeline.plays());
    CHECK(timeline.frame == timeline.frames() - 1.0);
    CHECK(scene.camera.r < start.r);
    timeline.follow(scene, false);  // still the same fall
    timeline.seek(scene, 0.0);
    CHECK(scene.camera.r == doctest::Approx(start.r).epsilon(1e-9));
    timeline.loops = true;
    timeline.play(true);
    for (int i = 0; i < 1000; ++i) REQUIRE(timeline.step(scene, 0.1));
    CHECK(timeline.plays());
}

TEST_CASE("timeline: keys are set, replaced and deleted; a path is of one observer") {
    Scene scene = shipped("first-light");
    Timeline timeline;
    timeline.follow(scene, true);
    REQUIRE(timeline.set_key(scene));
    REQUIRE(scene.path->keys.size() == 2);
    timeline.follow(scene, false);
    timeline.seek(scene, 100.0);
    scene.camera.r = 40.0;
    REQUIRE(timeline.set_key(scene));
    REQUIRE(scene.path->keys.size() == 3);
    timeline.follow(scene, false);
    timeline.seek(scene, 100.0);
    CHECK(scene.camera.r == 40.0);
    scene.camera.r = 41.0;
    REQUIRE(timeline.set_key(scene));
    CHECK(scene.path->keys.size() == 3);
    scene.path->easing = PathEasing::kSmooth;  // a key is met in the frame where it is set
    timeline.follow(scene, false);
    timeline.seek(scene, 60.0);
    scene.camera.r = 50.0;
    REQUIRE(timeline.set_key(scene));
    REQUIRE(scene.path->keys.size() == 4);
    CHECK(scene.path->keys[1].frame < 60.0);
    timeline.follow(scene, false);
    timeline.seek(scene, 60.0);
    CHECK(scene.camera.r == doctest::Approx(50.0).epsilon(1e-12));
    REQUIRE(timeline.delete_key(scene));
    CHECK(scene.path->keys.size() == 3);
    scene.path->easing = PathEasing::kNone;
    timeline.follow(scene, false);
    scene.camera.observer = ObserverKind::kRain;
    CHECK_FALSE(timeline.set_key(scene));
    timeline.frame = 90.0;
    REQUIRE(timeline.delete_key(scene));
    CHECK(scene.path->keys.size() == 2);
    CHECK_FALSE(timeline.delete_key(scene));
    timeline.record(scene);
    scene.camera.observer = ObserverKind::kStatic;
    CHECK_FALSE(timeline.sample(scene, 0.1));
    CHECK(timeline.recorded_s() == 0.0);
    CHECK_FALSE(timeline.stop_record(scene));  // too short
}

TEST_CASE("timeline: numbers that the keys set are the scene's in each frame, and its own again when it is saved") {
    auto read = parse_scene(
        "[spacetime]\nmetric = \"kerr\"\nspin = 0.2\n[path]\nkind = \"keys\"\nclosed = \"on\"\nframes = "
        "20\n[[path.key]]\n"
        "set = { spacetime.spin = -0.5 }\n[[path.key]]\nframe = 10\nphi = 90\nset = { spacetime.spin = 0.5 }\n",
        "mine.toml", {});
    REQUIRE(read);
    Scene scene = *read;
    Timeline timeline;
    timeline.follow(scene, true);
    const auto spin_at = [&](double frame) {
        timeline.seek(scene, frame);
        timeline.follow(scene, false);  // as the viewer does after each change
        return scene.spacetime.parameters.at("spin");
    };
    CHECK(spin_at(0) == -0.5);
    CHECK(spin_at(10) == 0.5);
    CHECK(std::fabs(spin_at(15)) < 1e-12);
    CHECK(spin_at(20) == doctest::Approx(-0.5));  // where it begins again
    spin_at(7);
    const Scene saved = timeline.to_save(scene);
    CHECK(saved.spacetime.parameters.at("spin") == 0.2);
    CHECK(saved.path == read->path);
}

}  // namespace
