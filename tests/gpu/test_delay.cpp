// The light-time table and what is seen late, in the shader's text and on the GPU, against the reference.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "against_reference.h"
#include "reference/frame_tracer.h"
#include "render/frame_tables.h"
#include "scenefile/scene_file.h"
#include "support/paired_cost.h"

using namespace nullscope;
using namespace nullscope::test;

TEST_CASE(
    "light time: the shader's text against the reference, on discs about holes with and without charge, near and far") {
    constexpr const char* kMetrics[] = {"schwarzschild", "reissner-nordstrom"};
    double worst = 0, worst_float = 0;
    std::string place;
    for (const char* name : kMetrics)
        for (const double r : {1.2, 1.5, 4.0, 25.0, 1000.0})
            for (const double theta : {20.0, 85.0}) {
                Scene scene;
                scene.spacetime.metric = name;
                if (scene.spacetime.metric == "reissner-nordstrom") scene.spacetime.parameters["charge"] = 1.0;
                scene.camera.r = r, scene.camera.theta = theta * M_PI / 180, scene.camera.width = 48,
                scene.camera.height = 27;
                scene.camera.plane_width = 2 * std::tan(std::min(1.2, 20 / r));
                scene.disc.emplace();
                scene.disc->inner = 1.6, scene.disc->outer = 12, scene.disc->flow = DiscFlowKind::kKepler;
                FrameTables tables;
                REQUIRE(tables.update(scene));
                const CoreInput input = tables.core_input();
                auto tracer = *reference::FrameTracer::make(scene);
                const int step = test::by_depth(2, 1, 1);
                for (int y = 0; y < 27; y += step)
                    for (int x = 0; x < 48; x += step) {
                        const auto exact = tracer.pixel(x + 0.5, y + 0.5);
                        if (exact.fate != Fate::kHit) continue;
                        const auto in_double = trace_core64(input, x - 23.5, 13 - y),
                                   in_float = trace_core32(input, x - 23.5, 13 - y);
                        if (in_double.fate != Fate::kHit || in_float.fate != Fate::kHit ||
                            in_float.order != exact.order)
                            continue;  // the rims
                        const double scale = std::max(exact.delay, 5.0),
                                     off = std::fabs(in_float.delay - exact.delay) / scale;
                        worst = std::max(worst, std::fabs(in_double.delay - exact.delay) / scale);
                        if (off > worst_float)
                            place = fmt::format("{}, camera {} r_s, {} degrees, at {:.3f} r_s", name, r, theta,
                                                std::hypot(exact.u, exact.v));
                        worst_float = std::max(worst_float, off);
                    }
            }
    fmt::print("light time to the disc: core64 off by at most {:.2g}, core32 {:.2g} of it, or of 5 r_s ({})\n", worst,
               worst_float, place);
    // The map's zeta is off by 1e-7, which far out is r^2 times that and next to the turning point the slope's error over zeta.
    constexpr double kMap = 1e-5, kFloat = 2e-5;
    CHECK(worst < kMap);
    CHECK(worst_float < kFloat);
}

namespace {

// A frame's cost over that of one whose light takes no time: 1 / (1 - share of light times).
test::PairedCost cost_of_delay(const std::string& name, int pairs) {
    constexpr int kWidth = 640, kHeight = 360;
    auto session = test::open_gpu("egl");  // OSMesa: the same rasteriser
    REQUIRE(session);
    Scene late = *load_scene(name);
    late.camera.width = kWidth, late.camera.height = kHeight;
    Scene at_once = late;
    at_once.light.delay = false;
    Renderer& renderer = *session->renderer;
    const gl::Target target = gl::make_target(kWidth, kHeight, gl::Format::kRgba8);
    const auto draw = [&] { renderer.draw(target.framebuffer.id(), kWidth, kHeight, Output::kDisplay); };
    const test::PairedCost cost =
        test::paired_cost(pairs, draw, draw, [&](bool first) { REQUIRE(renderer.prepare(first ? late : at_once)); });
    fmt::print("{}: {:.4f} core-s, with light that takes no time {:.4f}: the share of light times {:.3f}\n", name,
               cost.first_s, cost.second_s, 1 - 1 / cost.ratio);
    return cost;
}

}  // namespace

TEST_CASE("light time: what the light-time table costs of the frame that needs it" * test::costly()) {
    constexpr double kMost = 0.15;  // issue: "at most 15 % of the frame that needs it"
    const int pairs = test::by_depth(21, 61, 61);
    const double most = 1 / (1 - kMost);
    CHECK(test::within(most, [&] { return cost_of_delay("hot-spot", pairs); }).low <= most);
    bool seen = false;  // that the check can fail: 1.27 in the median, 1.14 met once beside other work
    for (int tries = 0; tries < 4 && !seen; ++tries) seen = cost_of_delay("late-light", 5).ratio > most;
    CHECK(seen);
}

// A body that moves is met elsewhere then: it comes along while light is on its way, and the search takes more and shorter steps. The table is
// asked once where something may be met, some 0.05 of the frame.
TEST_CASE("light time: what it costs to follow a moving body in time") {
    constexpr double kMost = 0.5;
    if (const int pairs = test::by_depth(0, 9, 9); pairs > 0)
        CHECK(test::within(1 / (1 - kMost), [&] { return cost_of_delay("late-light", pairs); }).low <= 1 / (1 - kMost));
}

TEST_CASE(
    "what moves is met where the reference meets it, at every pixel, with and without the time that light takes") {
    const auto usual = [] { return Draft().sky(SkyKind::kBlack).at_time(30).place(22, 1.2).size(48, 27); };
    const auto ball = [&](BallMotion motion, Vec3 velocity = {0.1, 0.05, 0.25}) {
        return usual().body(
            BallSpec{{6, 0, 1}, 1.2, motion, velocity, "6 * cos(t / 9)", "6 * sin(t / 9)", "2 * sin(t / 5)"});
    };
    using enum BallMotion;
    constexpr Vec3 kInward{-0.3, 0.02, 0.1};
    Draft at_once = ball(kOrbit), straight = ball(kOrbit);
    at_once.scene.light.delay = false, straight.scene.light.lensing = false;
    const std::vector<FrameCase> cases = {
        {"ball on an orbit", ball(kOrbit)},
        {"ball in free fall", ball(kGeodesic)},
        {"gone: ball in free fall, long ago, into the hole", ball(kGeodesic, kInward).at_time(60)},
        {"ball in free fall, before it was let go", ball(kGeodesic, kInward).at_time(3)},
        {"ball in free fall, flat", ball(kGeodesic).metric("minkowski")},
        {"ball in free fall, charged hole", ball(kGeodesic).metric("reissner-nordstrom", {{"charge", 0.8}})},
        {"ball on a given path", ball(kPath)},
        {"ball on a given path, flat", ball(kPath).metric("minkowski")},
        {"ball on an orbit, light without delay", at_once},
        {"ball on an orbit, straight light", straight},
        {"ball on an orbit, extremal hole", ball(kOrbit).metric("reissner-nordstrom", {{"charge", 1.0}})},
        {"ball on an orbit, a camera that falls", ball(kOrbit).by(ObserverKind::kRain)},
        {"sphere that pulsates", usual().body(SphereSpec{4, 0.3, 12})},
        {"surface with t in it", usual().surface("length(x, y, z) - 4 - 0.6 * sin(0.5 * t + 3 * atan(y, x))", 6)},
    };
    Promise promise{.place = kEveryRay_px, .swept = kEveryRay_px, .least_hits = 1};
    AgainstReference judge("moving", promise);
    promise.least_hits = 0;
    AgainstReference of_nothing("moving", promise);
    on_one_context([&](GpuSession& session) {
        Selection selection(3);
        for (const auto& [name, scene] : cases) {
            if (!selection.takes_next()) continue;
            const bool gone = name.starts_with("gone");
            const auto m = (gone ? of_nothing : judge).frame(session, name, scene);
            if (gone && m) CHECK(m->place_px.count == 0);
        }
    });
}
