// Views into the photon ring, to any depth, against exact arithmetic.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "observer/ring_view.h"
#include "proof/exact_ring.h"
#include "proof/settings.h"
#include "render/frame_tables.h"
#include "shadercore/core_trace.h"
#include "spacetime/registry.h"
#include "support/costly.h"

namespace {

using namespace nullscope;
using namespace nullscope::proof;

constexpr double kAllowed_px = 0.05;
constexpr double kEdge_px = 0.01;    // from the critical curve: closer to it a fate may be the other
constexpr double kBeside_px = 1e-4;  // over which differences are taken

struct RingViewWorst {
    double sky_px = 0, disc_px = 0;
    int rays = 0, on_disc = 0;
};

Scene zoomed(double distance) {
    Scene scene;
    scene.camera = {.r = 20, .theta = 1.2, .phi = 0.4, .width = 1280, .height = 720};
    scene.camera.roll = 0.3;
    scene.camera.plane_width = 0.2;
    // The picture's corner is at this distance from the critical curve, relative to it.
    const double shadow = std::asin(1.5 * std::sqrt(3.0) * std::sqrt(1 - 1 / 20.0) / 20.0);
    scene.camera.zoom = ZoomSpec{std::log(0.1) - std::log(distance) - std::log(shadow), 0.9};
    scene.disc.emplace();
    scene.disc->inner = 3, scene.disc->outer = 15;
    scene.sky.kind = SkyKind::kBlack;
    return scene;
}

double apart(const std::array<double, 3>& a, Vec3 b) { return std::hypot(a[0] - b.x, a[1] - b.y, a[2] - b.z); }
double apart(const std::array<double, 2>& a, double x, double y) { return std::hypot(a[0] - x, a[1] - y); }

// How far the exact answer moves over a pixel, at most.
template <class Of>
double motion(const ExactRing& exact, double x, double y, const Of& of) {
    return std::max(of(exact.ray(x + kBeside_px, y)), of(exact.ray(x, y + kBeside_px))) / kBeside_px;
}

RingViewWorst judge(const Scene& scene, RayPixel (*core)(const CoreInput&, double, double), int rays, Random& random) {
    FrameTables tables;
    const Status ready = tables.update(scene);
    REQUIRE_MESSAGE(ready, (ready ? "" : ready.error().message()));
    const CoreInput input = tables.core_input();
    const ExactRing exact(scene);
    RingViewWorst worst;
    for (int i = 0; i < rays; ++i) {
        const double x = random.between(-640, 640), y = random.between(-360, 360);
        const RayPixel tested = core(input, x, y);
        const ExactRingRay right = exact.ray(x, y);
        CAPTURE(x);
        CAPTURE(y);
        if (right.disc) {
            // An edge of the disc may be on the pixel.
            const double there = motion(exact, x, y, [&](const ExactRingRay& beside) {
                return beside.disc ? apart(*beside.disc, (*right.disc)[0], (*right.disc)[1]) : 0.0;
            });
            const auto meets = [&](double dx, double dy) { return exact.ray(x + dx, y + dy).disc.has_value(); };
            if (tested.hit != kDiscHit) {
                CHECK_FALSE((meets(kAllowed_px, 0) && meets(-kAllowed_px, 0) && meets(0, kAllowed_px) &&
                             meets(0, -kAllowed_px)));
                continue;
            }
            worst.disc_px = std::max(worst.disc_px, apart(*right.disc, tested.u, tested.v) / there);
            ++worst.on_disc;
        } else if (right.escapes) {
            if (tested.fate != Fate::kEscaped) {
                const bool edge = !exact.ray(x + kEdge_px, y).escapes || !exact.ray(x - kEdge_px, y).escapes ||
                                  !exact.ray(x, y + kEdge_px).escapes || !exact.ray(x, y - kEdge_px).escapes;
                const bool rim = exact.ray(x + kAllowed_px, y).disc || exact.ray(x - kAllowed_px, y).disc ||
                                 exact.ray(x, y + kAllowed_px).disc || exact.ray(x, y - kAllowed_px).disc;
                CHECK((edge || rim));
                continue;
            }
            const double there = motion(exact, x, y, [&](const ExactRingRay& beside) {
                return apart(beside.sky, {right.sky[0], right.sky[1], right.sky[2]});
            });
            worst.sky_px = std::max(worst.sky_px, apart(right.sky, tested.sky) / there);
            CHECK(std::abs(tested.order - right.order) <= 1);  // the angle is a float of some 700 rad
            ++worst.rays;
        } else {
            const bool edge = exact.ray(x + kEdge_px, y).escapes || exact.ray(x - kEdge_px, y).escapes ||
                              exact.ray(x, y + kEdge_px).escapes || exact.ray(x, y - kEdge_px).escapes;
            CHECK((tested.fate == Fate::kCaptured || tested.hit == kDiscHit || edge));
        }
    }
    return worst;
}

struct DepthView {
    std::string name;
    ObserverKind observer;
    Vec3 velocity;
};

}  // namespace

TEST_CASE("zoom: directions and disc places are those of exact arithmetic, to 1e-300" * test::costly()) {
    const std::vector<DepthView> views = {{"at rest", ObserverKind::kStatic, {}},
                                          {"0.7 c aside", ObserverKind::kStatic, {0.2, -0.3, 0.6}},
                                          {"falling", ObserverKind::kRain, {}},
                                          {"in orbit", ObserverKind::kOrbit, {}}};
    Random random(seed());
    const bool quick = test::by_depth(0, 1, 1) == 0;
    for (const double distance : {1e-3, 1e-8, 1e-15, 1e-30, 1e-100, 1e-300})
        for (const DepthView& view : views) {
            if (quick && ((distance != 1e-15 && distance != 1e-300) || &view - views.data() > 1)) continue;
            Scene scene = zoomed(distance);
            scene.camera.observer = view.observer;
            scene.camera.velocity = view.velocity;
            for (const auto& [name, core] : {std::pair{"core64", &trace_core64}, {"core32", &trace_core32}}) {
                const RingViewWorst worst = judge(scene, core, tries(30), random);
                CAPTURE(view.name);
                CAPTURE(distance);
                CAPTURE(name);
                MESSAGE(fmt::format("{:11} {:6.0e} {}: sky {:.1e} px ({} rays), disc {:.1e} px ({})", view.name,
                                    distance, name, worst.sky_px, worst.rays, worst.disc_px, worst.on_disc));
                CHECK(worst.sky_px <= kAllowed_px);
                CHECK(worst.disc_px <= kAllowed_px);
            }
        }
}

namespace {

// What decides which tables a depth is drawn with.
std::array<double, 2> tables_of(FrameTables& tables, const Scene& scene) {
    REQUIRE(tables.update(scene));
    return {tables.plan().ring->turns, tables.path().family()->w0()};
}

}  // namespace

TEST_CASE("zoom: a film of 2000 frames does not jump where tables or turns change") {
    constexpr double kJump_px = 1e-3, kStep = 0.05, kHalvings = 30;
    constexpr int kFrames = 2000;
    const int frames =
        test::by_depth(kFrames / 4, kFrames, kFrames);  // to a depth of 25, over the first change of turns
    Scene film = zoomed(1e-3), sky = film;
    sky.disc.reset();
    FrameTables tables, before, after;
    Random random(seed());
    const auto at = [&](Scene& scene, double depth) -> const Scene& { return scene.camera.zoom->depth = depth, scene; };
    int changes = 0;
    double worst = 0;
    auto last = tables_of(tables, at(sky, 0));
    for (int frame = 1; frame < frames; ++frame) {
        const auto here = tables_of(tables, at(sky, kStep * frame));
        if (here == last) continue;
        double low = kStep * (frame - 1), high = kStep * frame;
        for (int i = 0; i < kHalvings; ++i) {
            const double middle = 0.5 * (low + high);
            (tables_of(tables, at(sky, middle)) == last ? low : high) = middle;
        }
        last = here;
        ++changes;
        REQUIRE(before.update(at(film, low)));
        REQUIRE(after.update(at(film, high)));
        const CoreInput one = before.core_input(), other = after.core_input();
        for (int i = 0; i < 200; ++i) {
            const double x = random.between(-640, 640), y = random.between(-360, 360);
            const auto seen = [&](const CoreInput& input, double dx, double dy) {
                return trace_core64(input, x + dx, y + dy);
            };
            const RayPixel a = seen(one, 0, 0), b = seen(other, 0, 0), right = seen(one, 0.01, 0),
                           up = seen(one, 0, 0.01);
            if (a.fate != b.fate || a.hit != b.hit || right.hit != a.hit || up.hit != a.hit || right.fate != a.fate ||
                up.fate != a.fate)
                continue;
            const auto off = [&](const RayPixel& p, const RayPixel& q) {
                return a.hit == kDiscHit ? std::hypot(p.u - q.u, p.v - q.v) : length(p.sky - q.sky);
            };
            const double motion = std::max(off(a, right), off(a, up)) / 0.01;
            if (motion > 0) worst = std::max(worst, off(a, b) / motion);
        }
    }
    MESSAGE(fmt::format("{} changes, largest jump {:.1e} px", changes, worst));
    CHECK(changes > frames / 100);
    CHECK(worst <= kJump_px);
}

TEST_CASE("zoom: about a rotating hole nothing jumps where another swing is left out") {
    constexpr double kStep_px = 1e-4, kRotatingJump_px = 1e-3;
    double most = 0;
    int rays = 0;
    for (const double spin : {0.3, 0.9, 0.998})
        for (const double angle : {0.4, 1.7, 2.9}) {
            Scene scene;
            scene.spacetime = {"kerr", {{"spin", spin}}};
            CameraSpec& camera = scene.camera;
            camera.r = 12, camera.observer = ObserverKind::kZamo, camera.zoom.emplace();
            camera.theta = 1.1, camera.zoom->angle = angle, camera.velocity = {0.1, 0.2, -0.2};
            const auto spacetime = *make_spacetime("kerr", scene.spacetime.parameters);
            const auto turns = [&](double depth) {
                CameraSpec deeper = camera;
                deeper.zoom->depth = depth;
                return ring_view(*spacetime, deeper, {})->turns;
            };
            double before = 40, after = 60;  // of the change next to 40
            while (turns(after) - turns(before) > 1 || after - before > 1e-9) {
                const double middle = 0.5 * (before + after);
                (turns(middle) > turns(before) ? after : before) = middle;
            }
            const auto core = [&](double depth) {
                scene.camera.zoom->depth = depth;
                FrameTables tables;
                REQUIRE(tables.update(scene));
                return tables.core_input();
            };
            const CoreInput near = core(before), deep = core(after);
            for (double x = -600; x <= 600; x += 37)
                for (const double y : {-300.0, 20.0, 310.0}) {
                    const RayPixel a = trace_core64(near, x, y), b = trace_core64(deep, x, y);
                    CHECK(a.fate == b.fate);
                    if (a.fate != Fate::kEscaped || b.fate != a.fate) continue;
                    const double motion = std::hypot(length(trace_core64(near, x + kStep_px, y).sky - a.sky),
                                                     length(trace_core64(near, x, y + kStep_px).sky - a.sky)) /
                                          kStep_px;
                    most = std::max(most, length(a.sky - b.sky) / motion), ++rays;
                }
        }
    fmt::print("rotating: {} rays before and after a swing less, {:.1e} px apart\n", rays, most);
    CHECK(rays > 200);
    CHECK(most < kRotatingJump_px);
}
