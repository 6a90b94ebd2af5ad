// Bodies on both sides of a wormhole: every pixel of many small frames against the reference, which finds them along its own orbits.
#include "against_reference.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

Draft sides_draft(const char* metric, MetricParameters parameters = {}) {
    Draft draft;
    draft.scene.far_sky.kind = SkyKind::kBlack;
    return draft.metric(metric, std::move(parameters)).sky(SkyKind::kBlack).r(8).size(97, 55);
}
Draft ellis() { return sides_draft("ellis"); }
Draft film(double length = 0.01, double width = 0.05) {  // the reference takes milliseconds a ray
    return sides_draft("dneg-wormhole", {{"throat", 1.0}, {"length", length}, {"lensing_width", width}})
        .size(by_depth(27, 43, 65), by_depth(17, 25, 37));
}

TEST_CASE("sides: hits, places and fates are the reference's at every pixel" * test::costly()) {
    constexpr bool kFar = true;
    constexpr Vec3 kNear{4, 2, -0.5}, kBehind{-4, 1, 0.5}, kFront{5, 1, 0};
    const std::vector<FrameCase> cases = {
        {"ellis: ball near", ellis().ball(kNear, 1)},
        {"ellis: ball behind the throat, near", ellis().ball({-4, 0.3, 0}, 1.5)},
        {"ellis: ball far, behind", ellis().ball(kBehind, 1.5, kFar)},
        {"ellis: ball far, in front", ellis().ball(kFront, 1.5, kFar)},
        {"ellis: ball far, next to the throat", ellis().ball({-1.6, 0, 0.2}, 1.5, kFar)},
        {"ellis: ring far", ellis().cylinder(2, 4, 0.3, kFar)},
        {"ellis: ring near, ball far", ellis().ball(kBehind, 1.5, kFar).cylinder(2, 3, 0.2)},
        {"ellis: ball near, surface far", ellis().ball(kNear, 1).surface("length(x + 4, y, z) - 1.5", 6, kFar)},
        {"ellis: camera far, ball near", ellis().ball(kNear, 1).r(-5).yaw(M_PI)},
        {"ellis: camera in the throat, ball far", ellis().ball(kFront, 1.5, kFar).r(0)},
        {"ellis: camera in the throat, ball near", ellis().ball(kNear, 1).r(0).yaw(M_PI)},
        {"ellis: ball far, fast camera", ellis().ball(kBehind, 1.5, kFar).moving({0.3, 0.2, 0.1})},
        {"ellis: wide throat, ball far", sides_draft("ellis", {{"throat", 5.0}}).ball({-12, 2, 1}, 1.5, kFar).r(20)},
        {"film's: ball near", film().ball(kNear, 1)},
        {"film's: ball far", film().ball(kBehind, 1.5, kFar)},
        {"film's: ring far, ball near", film().ball(kNear, 1).cylinder(2, 4, 0.3, kFar)},
        {"film's: camera in the tube, ball far", film().ball(kFront, 1.5, kFar).r(0.001)},
        {"longest tube, widest lens: ball far", film(0.5, 2.0).ball(kBehind, 1.5, kFar)},
        {"no tube, narrowest lens: ball far", film(0, 0.02).ball(kFront, 1.5, kFar).r(4)},
    };
    AgainstReference judge("sides",
                           {.sky = kEveryRay_px, .place = kEveryRay_px, .swept = kEveryRay_px, .least_hits = 1});
    // At quick depth none of the film's wormhole, whose table takes ten seconds: unit tests have it.
    on_every_context([&](GpuSession& session) { judge.frames(session, Selection(12), cases); });
}

}  // namespace
