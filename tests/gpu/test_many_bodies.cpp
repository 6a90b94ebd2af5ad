// Scenes of many bodies: sixty-four balls of every motion, and lists of every kind with their names, against the reference.
#include <fmt/format.h>

#include <map>
#include <set>
#include <vector>

#include "against_reference.h"
#include "scenefile/scene_file.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

// Checks a frame at every pixel; the numbers of the bodies that are seen.
std::set<int> check_frame(GpuSession& session, AgainstReference& judge, const Scene& scene) {
    judge.frame(session, scene.name, scene);
    std::set<int> seen;
    for (const RayPixel& pixel : judge.drawn().pixels) seen.insert(pixel.hit);
    return seen;
}

std::set<std::string> names_of(const Scene& scene, const std::set<int>& numbers) {
    std::set<std::string> names;
    for (const int number : numbers) names.insert(object_name(scene, number));
    return names;
}

AgainstReference many_bodies() {
    return {"many bodies",
            {.sky = kEveryRay_px,
             .place = kEveryRay_px,
             .swept = kEveryRay_px,
             .of_width = 1920,
             .least_hits = 1,
             .which = true}};
}

Draft many_about(const char* metric) {
    Draft draft;
    draft.scene.name = metric;
    return draft.metric(metric, metric == std::string("kerr") ? MetricParameters{{"spin", 0.8}} : MetricParameters{})
        .sky(SkyKind::kBlack);
}

TEST_CASE("many bodies: sixty-four balls of every motion, each pixel as the reference has it" * test::costly()) {
    AgainstReference judge = many_bodies();
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
        const std::set<int> seen = check_frame(session, judge, scene);
        CHECK(seen.size() > by_depth(20u, 40u, 40u));
    });
}

TEST_CASE("many bodies: several of every kind, of one texture and of others, about holes and in a wormhole" *
          test::costly()) {
    AgainstReference judge = many_bodies();
    on_every_context([&](GpuSession& session) {
        for (const char* metric : {"schwarzschild", "kerr", "ellis"}) {
            CAPTURE(metric);
            Scene scene = many_about(metric).size(by_depth(48, 96, 192), by_depth(27, 54, 108));
            const bool wormhole = scene.spacetime.metric == "ellis";
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
            const std::set<std::string> names = names_of(scene, check_frame(session, judge, scene));
            for (const char* name : {"cylinder", "cylinder-2", "ball", "ball-2", "surface", "surface-2"})
                CHECK_MESSAGE(names.contains(name), name);
            CHECK(names.contains("sphere-2") == !wormhole);  // the first lies within it
        }
    });
}

// Light that has come this far out cannot have left the near one yet: it was taken to be nowhere, and steps to be free.
TEST_CASE("many bodies: a ball before the hole and one far behind it, each on its orbit" * test::costly()) {
    AgainstReference judge = many_bodies();
    on_every_context([&](GpuSession& session) {
        for (const char* metric : {"schwarzschild", "kerr"}) {
            CAPTURE(metric);
            Draft draft = many_about(metric).place(26.0, 1.29).plane(0.85).at_time(40);
            draft.size(by_depth(64, 192, 192), by_depth(36, 108, 108));
            for (const Vec3 place : {Vec3{4.95, -4.95, 0}, Vec3{-24, 0, 0}})
                draft.body(BallSpec{.position = place, .radius = 0.4, .motion = BallMotion::kOrbit});
            CHECK(names_of(draft, check_frame(session, judge, draft)).contains("ball"));
        }
    });
}

}  // namespace
