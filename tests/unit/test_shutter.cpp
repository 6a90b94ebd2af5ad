// Sub-frames of a frame: where they lie in time, and which need not be drawn.
#include <doctest/doctest.h>

#include <cmath>

#include "base/result.h"
#include "image/image.h"
#include "observer/path.h"
#include "plan/shutter.h"
#include "scene/exposure.h"

namespace {

using namespace nullscope;

constexpr double kStep = 0.25;  // r_s/c a frame

double shares(const Exposure& shown) {
    double sum = 0;
    for (const SubFrame& sub_frame : shown.sub_frames) sum += sub_frame.share;
    return sum;
}

TEST_CASE("shutter: sub-frames lie about the frame, and only what moves has them") {
    Scene scene;
    const auto at = [&](double frame) {
        Scene now = scene;
        now.time = frame * kStep;
        return now;
    };
    scene.bodies.push_back({.shape = SphereSpec{}});
    CHECK(exposure_of(at, 7).sub_frames.empty());  // it is shut
    scene.picture.shutter = 0.5;
    CHECK(exposure_of(at, 7).sub_frames.empty());  // nothing moves
    std::get<SphereSpec>(scene.bodies[0].shape).amplitude = 0.1;
    const Exposure shown = exposure_of(at, 7);
    CHECK(shown.scene.time == 7 * kStep);
    REQUIRE(shown.sub_frames.size() == 16);
    CHECK(std::fabs(shares(shown) - 1) < 1e-15);
    CHECK(shown.sub_frames.front().scene.time == doctest::Approx((7 - 0.25 + 0.5 / 32) * kStep).epsilon(1e-14));
    CHECK(shown.sub_frames.back().scene.time == doctest::Approx((7 + 0.25 - 0.5 / 32) * kStep).epsilon(1e-14));
    scene.picture.sub_frames = 1;
    CHECK(exposure_of(at, 7).sub_frames.empty());
}

TEST_CASE("shutter: a camera that rests for a part of the time is drawn once there") {
    Scene scene;
    scene.path.emplace().kind = PathKind::kKeys;
    for (int i = 0; i < 2; ++i) scene.path->keys.push_back({10.0 * i, scene.camera, 0});
    scene.path->keys[1].camera.yaw = 1;
    scene.path->frames = 11;
    scene.picture.shutter = 1;
    const auto path = CameraPath::make(scene);
    REQUIRE(path);
    const auto at = [&](double frame) {
        Scene now = scene;
        now.camera = path->at(frame);
        return now;
    };
    CHECK(exposure_of(at, 4).sub_frames.size() == 16);
    const Exposure first = exposure_of(at, 0), last = exposure_of(at, 10);
    REQUIRE(first.sub_frames.size() == 9);
    CHECK(first.sub_frames.front().share == 0.5);
    CHECK(last.sub_frames.size() == 9);
    CHECK(last.sub_frames.back().share == 0.5);
    scene.path->keys[1].camera.yaw = 0, scene.path->keys[1].camera.exposure_ev = 3;  // of the mean
    const auto still = CameraPath::make(scene);
    REQUIRE(still);
    const auto at_rest = [&](double frame) {
        Scene now = scene;
        now.camera = still->at(frame);
        return now;
    };
    CHECK(exposure_of(at_rest, 5).sub_frames.empty());
}

TEST_CASE("shutter: the mean of light, by shares") {
    Exposure shown{Scene{}};
    const auto light = [](const Scene& scene) -> Result<Image<float>> {
        if (scene.time > 90) return failed("dark");
        Image<float> image(2, 1, 3);
        for (float& value : image.data) value = static_cast<float>(scene.time);
        return image;
    };
    shown.scene.time = 5;
    CHECK(mean_light(shown, light)->data[3] == 5);
    shown.sub_frames = {{0.75, shown.scene}, {0.25, shown.scene}};
    shown.sub_frames[1].scene.time = 9;
    CHECK(mean_light(shown, light)->data[5] == 6);
    const Exposure later = changed(shown, [](Scene scene) {
        scene.time += 1;
        return scene;
    });
    CHECK(later.scene.time == 6);
    CHECK(mean_light(later, light)->data[0] == 7);
    shown.sub_frames[1].scene.time = 99;
    CHECK(!mean_light(shown, light));
}

}  // namespace
