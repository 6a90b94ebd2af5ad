// Where what a picture shows moves to (gradient/picture_motion.h): by turns of the camera as its projection says, by other keys as the reference finds the
// same place of sky or disc again.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "changed_scene.h"
#include "gradient/picture_motion.h"
#include "observer/pose.h"
#include "reference/frame_tracer.h"
#include "scene/projection.h"
#include "scenefile/scene_file.h"
#include "support/costly.h"

namespace {

using namespace nullscope;

constexpr double kPictureSide = 200;  // px
constexpr int kPlaces = 30;

Scene motion_scene(const char* metric, MetricParameters parameters, bool disc) {
    Scene scene;
    scene.spacetime = {metric, std::move(parameters)};
    scene.camera.r = 12.0, scene.camera.theta = 1.2, scene.camera.phi = 0.3;
    scene.camera.observer = ObserverKind::kStatic;
    scene.camera.width = scene.camera.height = static_cast<int>(kPictureSide);
    scene.camera.yaw = 0.1, scene.camera.pitch = -0.05, scene.camera.roll = 0.4;
    scene.camera.plane_width = 1.1;
    if (disc) {
        scene.disc = DiscSpec{};
        scene.disc->inner = 3.0, scene.disc->outer = 9.0, scene.disc->lean = {0.2, 0.5, 0.0};
    }
    return scene;
}

Scene with_more(Scene scene, const std::string& key, double by) {
    test::change_scene(parse_parameters({key}, scene)->front().kind, by, scene);
    return scene;
}

TEST_CASE("picture motion: turns and widths of the camera move all as its projection says, whatever is seen") {
    constexpr double kStep = 1e-4,
                     kBound = 1e-6;  // rad; of the motion: the differences' own error is a hundredth of that
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(0.0, kPictureSide);
    const Scene scene = motion_scene("kerr", {{"spin", 0.7}}, true);
    for (const char* key : {"camera.yaw", "camera.pitch", "camera.roll", "camera.fov"}) {
        const auto motion = PictureMotion::make(scene, {key});
        REQUIRE(motion);
        int seen = 0;
        for (int i = 0; i < kPlaces; ++i) {
            const double x = place(random), y = place(random);
            const PictureMotion::Place at = (*motion)->at(x, y);
            const auto& found = at.by.front().move;
            if (!found) continue;
            const Vec3 direction = static_from_camera(scene.camera) * pixel_direction(scene.camera, x, y);
            const auto moved = [&](double by) {
                const Scene other = with_more(scene, key, by);
                return *pixel_of(other.camera, transposed(static_from_camera(other.camera)) * direction);
            };
            const auto after = moved(kStep), before = moved(-kStep);
            const double right = (after[0] - before[0]) / (2 * kStep), down = (after[1] - before[1]) / (2 * kStep);
            const double most = kBound * std::max(1.0, std::hypot(right, down));
            INFO(key, " at ", x, ", ", y);
            CHECK(std::hypot(found->right - right, found->down - down) < most);
            ++seen;
        }
        CHECK(seen > kPlaces / 2);
    }
}

// What is seen first there: a place in the disc's plane (nothing of the third number), or of the sky.
struct SeenThere {
    bool disc = false;
    Vec3 at{};
};
std::optional<SeenThere> seen_by_reference(const reference::FrameTracer& tracer, double x, double y) {
    const auto ray = tracer.ray(x, y);
    if (const auto hits = tracer.disc_hits(*ray, 1); !hits.empty()) return SeenThere{true, {hits[0].x, hits[0].y, 0}};
    if (ray->fate() != Fate::kEscaped) return std::nullopt;
    return SeenThere{false, ray->end_direction()};
}

struct MotionCase {
    const char* metric;
    MetricParameters parameters;
    bool disc;
    std::vector<const char*> keys;
};

// A place moved by what was found is the place that the reference sees there with another value of the key: what is left of the difference
// between the two values is of third order.
TEST_CASE("picture motion: the reference sees the same place again where it has moved to") {
    constexpr double kStep = 1e-4, kBound = 1e-5, kFromCritical_px = 4;  // 4e-7 measured
    constexpr double kFarthest_px =
        0.05;  // of one step: next to a fold of the picture the first derivative holds for less
    const std::vector<MotionCase> cases = {
        {"kerr", {{"spin", 0.7}}, true, {"spin", "camera.theta", "camera.phi", "disc.tilt", "disc.node"}},
        {"kerr", {{"spin", 0.7}}, false, {"spin", "camera.r", "camera.theta"}},
        {"schwarzschild", {}, true, {"camera.r", "camera.theta"}}};
    std::mt19937 random(2);
    std::uniform_real_distribution<double> place(0.0, kPictureSide);
    double worst = 0;
    for (const MotionCase& of : cases)
        for (const std::string key : of.keys) {
            const Scene scene = motion_scene(of.metric, of.parameters, of.disc);
            const auto motion = PictureMotion::make(scene, {key});
            REQUIRE(motion);
            const auto tracer_by = [&](double by) {
                auto tracer = reference::FrameTracer::make(with_more(scene, key, by));
                REQUIRE(tracer);
                return std::move(*tracer);
            };
            const auto less = tracer_by(-kStep), more = tracer_by(kStep);
            int judged = 0;
            for (int i = 0; i < kPlaces; ++i) {
                const double x = place(random), y = place(random);
                const PictureMotion::Place at = (*motion)->at(x, y);
                const auto& found = at.by.front().move;
                if (!found || at.off_critical < kFromCritical_px ||
                    std::hypot(found->right, found->down) * kStep > kFarthest_px)
                    continue;
                const auto with = [&](const reference::FrameTracer& tracer, double by) {
                    return seen_by_reference(tracer, x + by * found->right, y + by * found->down);
                };
                const auto before = with(less, -kStep), after = with(more, kStep), kept_before = with(less, 0),
                           kept_after = with(more, 0), beside = seen_by_reference(more, x + 1, y);
                if (!before || !after || !kept_before || !kept_after || !beside || before->disc != after->disc ||
                    kept_before->disc != kept_after->disc || before->disc != kept_before->disc ||
                    beside->disc != after->disc)
                    continue;
                // What stays, over what changes at a place that does not move, or a hundredth of what a pixel beside is off by.
                const double size =
                    std::max(length(kept_after->at - kept_before->at), 0.01 * length(beside->at - kept_after->at));
                const double off = length(after->at - before->at) / size;
                worst = std::max(worst, off);
                INFO(of.metric, " ", key, " at ", x, ", ", y);
                CHECK(off < kBound);
                ++judged;
            }
            INFO(of.metric, " ", key);
            CHECK(judged > kPlaces / 3);
        }
    fmt::print("places of sky and disc, moved with a key: within {:.1e} of the motion\n", worst);
}

TEST_CASE("picture motion: what falls in moves nowhere, and keys that the scene lacks are refused with those it has") {
    Scene scene = motion_scene("schwarzschild", {}, false);
    scene.camera.yaw = scene.camera.pitch = 0.0;  // to the hole's centre
    const auto motion = PictureMotion::make(scene, {"camera.theta"});
    REQUIRE(motion);
    const PictureMotion::Place at = (*motion)->at(kPictureSide / 2 + 3, kPictureSide / 2 - 2);
    CHECK_FALSE(at.by.front().move);
    CHECK_FALSE(at.sees_sky);
    const auto refused = PictureMotion::make(scene, {"spin"});
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message().find("camera.theta") != std::string::npos);
}

// Next to horizons, of charged and extremal holes, by formulas, from within throats: numbers, or a reason why there are none.
TEST_CASE("picture motion: of every scene that ships" * test::costly()) {
    int scenes = 0, places = 0;
    for (const SceneInfo& info : shipped_scenes()) {
        const auto scene = load_scene(info.name);
        REQUIRE(scene);
        for (const std::string_view key : parameter_names(*scene)) {
            const auto motion = PictureMotion::make(*scene, {std::string(key)});
            if (!motion) {
                CHECK_FALSE(motion.error().allowed.empty());
                break;
            }
            scenes += key == parameter_names(*scene).front() ? 1 : 0;
            for (int i = 0; i < 6; ++i) {
                const PictureMotion::Place at =
                    (*motion)->at(scene->camera.width * (0.1 + 0.16 * i), scene->camera.height * (0.3 + 0.08 * i));
                const PictureMotion::ByKey& by = at.by.front();
                INFO(info.name, " ", key);
                CHECK_FALSE(std::isnan(at.off_critical));
                CHECK((std::isfinite(by.sky.x) && std::isfinite(by.sky.y) && std::isfinite(by.sky.z)));
                CHECK((std::isfinite(by.shift) && std::isfinite(by.delay)));
                CHECK((!by.move || (std::isfinite(by.move->right) && std::isfinite(by.move->down))));
                places += by.move ? 1 : 0;
            }
        }
    }
    CHECK(scenes > 20);
    CHECK(places > 600);
}

}  // namespace
