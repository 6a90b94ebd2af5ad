// Scenes of many bodies: sixty-four balls of every motion, and lists of every kind with their names, against the reference.
#include <fmt/format.h>

#include <map>
#include <set>
#include <vector>

#include "scene/bodies.h"
#include "scenefile/scene_file.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kManyBodiesScreenError_px = 0.05;  // the project's promise, at 1080p: frames here are smaller
constexpr double kWidth_px = 1920;

// Checks a frame at every pixel; the numbers of the bodies that are seen.
std::set<int> check_frame(GpuSession& session, MeasuredOnce& measured, const Scene& scene) {
    const RayFrame frame = gl_ray_data(session, scene);
    std::set<int> seen;
    for (const RayPixel& pixel : frame.pixels) seen.insert(pixel.hit);
    if (measured.known(scene.name, frame)) return seen;
    const ExactTrace trace = remembered(reference_trace(scene));
    const RayMeasures m = measure_rays(frame, scene.camera, trace);
    const double scale = kWidth_px / scene.camera.width;
    fmt::print("{:<7} {:<28} of 1080p: screen {:.1e}, place {:.1e}, swept {:.1e} px; fate errors {}, forgiven {}\n",
               session.context->kind(), scene.name, scale * m.sky_px.max, scale * m.place_px.max,
               scale * m.angle_px.max, m.fate_errors, m.forgiven);
    CHECK(m.not_finite == 0);
    CHECK(m.fate_errors == 0);
    CHECK(m.place_px.count > 0);
    CHECK(scale * m.sky_px.max <= kManyBodiesScreenError_px);
    CHECK(scale * m.place_px.max <= kManyBodiesScreenError_px);
    CHECK(scale * m.angle_px.max <= kManyBodiesScreenError_px);
    // Which of the bodies, too: but for the pixels at edges that are forgiven.
    const RayFrame exact = exact_frame(scene.camera, trace);
    long long others = 0;
    for (std::size_t i = 0; i < exact.pixels.size(); ++i) others += exact.pixels[i].hit != frame.pixels[i].hit;
    CHECK(others <= m.forgiven);
    return seen;
}

TEST_CASE("many bodies: sixty-four balls of every motion, each pixel as the reference has it" * test::costly()) {
    MeasuredOnce measured;
    on_every_context([&](GpuSession& session) {
        Scene scene = *load_scene("swarm");
        REQUIRE(scene.bodies.size() == kMostBodies);
        std::map<BallMotion, int> motions;
        std::set<std::string> names;
        for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
            ++motions[std::get<BallSpec>(scene.bodies[i].shape).motion];
            names.insert(object_name(scene, object_number(scene, i)));
        }
        CHECK(motions.size() == 4);
        CHECK(names.size() == kMostBodies);
        CHECK(names.contains("herald"));
        scene.camera.width = by_depth(32, 64, 192), scene.camera.height = by_depth(18, 36, 108);
        const std::set<int> seen = check_frame(session, measured, scene);
        CHECK(seen.size() > by_depth(20u, 40u, 40u));
    });
}

TEST_CASE("many bodies: several of every kind, of one texture and of others, about holes and in a wormhole" *
          test::costly()) {
    MeasuredOnce measured;
    on_every_context([&](GpuSession& session) {
        for (const char* metric : {"schwarzschild", "kerr", "ellis"}) {
            CAPTURE(metric);
            Scene scene;
            scene.name = metric;
            scene.spacetime.metric = metric;
            const bool wormhole = scene.spacetime.metric == "ellis";
            if (scene.spacetime.metric == "kerr") scene.spacetime.parameters = {{"spin", 0.8}};
            scene.sky.kind = SkyKind::kBlack;
            scene.camera.width = by_depth(48, 96, 192), scene.camera.height = by_depth(27, 54, 108);
            if (!wormhole) add<SphereSpec>(scene).radius = 1.95, add<SphereSpec>(scene).radius = 2.0;
            add(scene, CylinderSpec{.inner = 3, .outer = 4, .height = 0.2});
            add_body(scene, CylinderSpec{.inner = 4.5, .outer = 5, .height = 0.6}).material.texture =
                TextureKind::kChecker;
            add(scene, BallSpec{.position = {6, 3, 1}, .radius = 1.0});
            add_body(scene, BallSpec{.position = {5, -4, -1}, .radius = 0.8}).material.texture = TextureKind::kStripes;
            add_body(scene, BallSpec{.position = {-5, 3, 3}, .radius = 0.8}).far = wormhole;
            const auto ball = [](const char* middle) {
                return SurfaceSpec{.shape = fmt::format("length(x, {}) - 1", middle), .bound = 9};
            };
            add(scene, ball("y - 6, z - 3")), add(scene, ball("y + 6, z + 3"));
            const std::set<int> seen = check_frame(session, measured, scene);
            std::set<std::string> names;
            for (const int number : seen) names.insert(object_name(scene, number));
            for (const char* name : {"cylinder", "cylinder-2", "ball", "ball-2", "surface", "surface-2"})
                CHECK_MESSAGE(names.contains(name), name);
            CHECK(names.contains("sphere-2") == !wormhole);  // the first lies within it
        }
    });
}

// Light that has come this far out cannot have left the near one yet: it was taken to be nowhere, and steps to be free.
TEST_CASE("many bodies: a ball before the hole and one far behind it, each on its orbit" * test::costly()) {
    MeasuredOnce measured;
    on_every_context([&](GpuSession& session) {
        for (const char* metric : {"schwarzschild", "kerr"}) {
            CAPTURE(metric);
            Scene scene;
            scene.name = metric;
            scene.spacetime.metric = metric;
            if (scene.spacetime.metric == "kerr") scene.spacetime.parameters = {{"spin", 0.8}};
            scene.sky.kind = SkyKind::kBlack;
            scene.camera.r = 26.0, scene.camera.theta = 1.29, scene.camera.plane_width = 0.85, scene.time = 40;
            scene.camera.width = by_depth(64, 192, 192), scene.camera.height = by_depth(36, 108, 108);
            for (const Vec3 place : {Vec3{4.95, -4.95, 0}, Vec3{-24, 0, 0}})
                add(scene, BallSpec{.position = place, .radius = 0.4, .motion = BallMotion::kOrbit});
            const std::set<int> seen = check_frame(session, measured, scene);
            std::set<std::string> names;
            for (const int number : seen) names.insert(object_name(scene, number));
            CHECK(names.contains("ball"));
        }
    });
}

}  // namespace
