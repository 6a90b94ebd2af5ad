// What a frame is made of is decided once.
#include "plan/frame_plan.h"

#include <doctest/doctest.h>

#include "scene/bodies.h"

using namespace nullscope;

namespace {

Scene moving_scene(const char* metric) {
    Scene scene;
    scene.spacetime.metric = metric;
    scene.camera.r = 10;
    scene.camera.observer = ObserverKind::kRain;
    return scene;
}

}  // namespace

TEST_CASE("frame plan: effects are those that the scene calls for, and their reasons are kept") {
    const Scene scene = moving_scene("schwarzschild");
    const auto plan = plan_frame(scene);
    REQUIRE(plan);
    CHECK(plan->scene.camera == scene.camera);
    CHECK(plan->effects == effect_set(required_effects(scene)));
    CHECK(plan->reasons.size() == plan->effects.size());
    CHECK(plan->observer.frame == observer_of(*plan->matter, scene.camera)->frame);
    CHECK(plan->matter == plan->light);
    CHECK_FALSE(plan->straight());
}

TEST_CASE("frame plan: straight light is that of flat space, its matter that of the scene") {
    Scene scene;
    scene.light.lensing = false;
    const auto plan = plan_frame(scene);
    REQUIRE(plan);
    CHECK(plan->straight());
    CHECK(plan->light->name() == "minkowski");
    CHECK(plan->matter->name() == "schwarzschild");
}

TEST_CASE("frame plan: spacetimes are kept from plan to plan as long as they are the same") {
    Scene scene;
    const auto first = plan_frame(scene);
    REQUIRE(first);
    scene.camera.r = 30;
    const auto second = plan_frame(scene, false, &*first);
    REQUIRE(second);
    CHECK(second->matter == first->matter);
    CHECK(second->light == first->light);
    scene.light.lensing = false;
    const auto straight = plan_frame(scene, false, &*second);
    REQUIRE(straight);
    CHECK(straight->matter == first->matter);
    CHECK(straight->light != first->light);
    CHECK(plan_frame(scene, false, &*straight)->light == straight->light);
    scene.spacetime = {"reissner-nordstrom", {{"charge", 0.4}}};
    CHECK(plan_frame(scene, false, &*straight)->matter != first->matter);
}

TEST_CASE("frame plan: light times that are wished for are there where the metric can tell them") {
    Scene scene;
    CHECK_FALSE(plan_frame(scene)->effects.contains(Effect::kLightTimes));
    CHECK(plan_frame(scene, true)->effects.contains(Effect::kLightTimes));
    CHECK_FALSE(plan_frame(scene, true)->effects.contains(Effect::kInnerHorizon));
    scene.spacetime = {"reissner-nordstrom", {{"charge", 0.4}}};
    CHECK(plan_frame(scene, true)->effects.contains(Effect::kInnerHorizon));
    scene.spacetime = {"ellis", {}};
    CHECK_FALSE(plan_frame(scene, true)->effects.contains(Effect::kLightTimes));
}

TEST_CASE("frame plan: light times that are wished for leave it to the scene whether things are seen late") {
    for (const bool moves : {false, true})
        for (const bool delay : {false, true})
            for (const bool wished : {false, true}) {
                Scene scene;
                scene.light.delay = delay;
                if (moves) add<BallSpec>(scene).motion = BallMotion::kOrbit;
                const EffectSet effects = plan_frame(scene, wished)->effects;
                CHECK(effects.contains(Effect::kDelay) == (moves && delay));
                CHECK(effects.contains(Effect::kLightTimes) == ((moves && delay) || wished));
                EffectSet others = effects;
                others.erase(Effect::kLightTimes);
                EffectSet scenes = plan_frame(scene)->effects;
                scenes.erase(Effect::kLightTimes);
                CHECK(others == scenes);
            }
}

TEST_CASE("frame plan: what cannot be is said with what is allowed") {
    Scene scene;
    scene.spacetime.metric = "schwarzshild";
    CHECK_FALSE(plan_frame(scene));
    scene.spacetime.metric = "schwarzschild";
    scene.camera.r = 0.5;
    const auto inside = plan_frame(scene);
    REQUIRE_FALSE(inside);
    CHECK(inside.error().message().find("allowed") != std::string::npos);
    scene.camera.r = 10;
    scene.spacetime.metric = "neutron-star";
    scene.disc.emplace();
    CHECK_FALSE(plan_frame(scene));
}
