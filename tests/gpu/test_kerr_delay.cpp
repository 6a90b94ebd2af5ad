// How long light takes about a rotating hole: the reference's Kerr-Schild time against metrics without spin, the shader's text against it.
#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "observer/pose.h"
#include "reference/frame_tracer.h"
#include "render/frame_tables.h"
#include "shadercore/core_trace.h"
#include "support/costly.h"

namespace {

using namespace nullscope;

Scene scene_at(double spin, double r, double theta, ObserverKind observer) {
    Scene scene;
    scene.spacetime = spin > 0 ? SpacetimeSpec{"kerr", {{"spin", spin}}} : SpacetimeSpec{"schwarzschild", {}};
    scene.camera.r = r, scene.camera.theta = theta, scene.camera.observer = observer;
    scene.camera.width = 32, scene.camera.height = 18;
    scene.disc.emplace().inner = 1.6, scene.disc->outer = 12;
    scene.disc->flow = DiscFlowKind::kKepler;
    return scene;
}

TEST_CASE(
    "kerr light time: a hole that hardly spins is Schwarzschild's, for cameras at rest and falling, to the sky and to "
    "a disc") {
    constexpr double kPromised = 1e-6;  // r_s: what a spin of 1e-9 changes, and sums of 1e9 r_s
    double worst = 0;
    int rays = 0;
    for (const ObserverKind observer : {ObserverKind::kStatic, ObserverKind::kRain})
        for (const double r : {1.5, 6.0, 200.0}) {
            const auto spun = *reference::FrameTracer::make(scene_at(1e-9, r, 1.3, observer)),
                       still = *reference::FrameTracer::make(scene_at(0, r, 1.3, observer));
            for (int y = 0; y < 18; ++y)
                for (int x = 0; x < 32; ++x) {
                    const auto a = spun.pixel(x + 0.5, y + 0.5), b = still.pixel(x + 0.5, y + 0.5);
                    if (a.fate != b.fate || a.hit != b.hit || b.angle > 6.0 || a.fate == Fate::kCaptured) continue;
                    worst = std::max(worst, std::fabs(a.delay - b.delay) / std::max(1.0, b.delay)), ++rays;
                }
        }
    fmt::print("spin 1e-9 against none: {} rays, light times differ by at most {:.1e} of them, or r_s\n", rays, worst);
    CHECK(rays > 1000);
    CHECK(worst < kPromised);
}

TEST_CASE("kerr light time: the shader's text against the reference, to the sky and to a disc" * test::costly()) {
    struct Worst {
        double off = 0;
        std::string where = "";
    } in_double, in_float;
    int rays = 0;
    for (const double spin : {0.5, 0.9, 0.998})
        for (const ObserverKind observer : {ObserverKind::kZamo, ObserverKind::kRain})
            for (const double r : {0.9, 2.0, 8.0, 1000.0})
                for (const double theta : {0.3, 1.5}) {
                    const Scene scene = scene_at(spin, r, theta, observer);
                    FrameTables tables;
                    if (!tables.update(scene)) continue;
                    const CoreInput input = tables.core_input();
                    const auto tracer = *reference::FrameTracer::make(scene);
                    for (int y = 0; y < 18; ++y)
                        for (int x = 0; x < 32; ++x) {
                            const auto exact = tracer.pixel(x + 0.5, y + 0.5);
                            const double px = x - 15.5, py = 8.5 - y;
                            const auto a = trace_core64(input, px, py), b = trace_core32(input, px, py);
                            if (exact.fate == Fate::kCaptured || exact.fate == Fate::kNoSky || a.fate != exact.fate ||
                                b.fate != exact.fate || a.hit != exact.hit)
                                continue;
                            // What a direction's last bit moves it by: next to the critical ray without end.
                            const auto beside = trace_core64(input, px + 1e-5, py + 1e-5);
                            const double sway = std::fabs(beside.delay - a.delay) / 1e-5 * 2e-3,
                                         scale = std::max(1.0, exact.delay);  // a float's bit is some 1e-6 px
                            const auto look = [&](Worst& worst, double found, double tolerance_px) {
                                const double off = std::fabs(found - exact.delay) / (scale + sway * tolerance_px);
                                if (!(off <= worst.off))
                                    worst = {
                                        off,
                                        fmt::format("a/M {} observer {} r {} theta {} pixel {} {}: {} for {}, fate {}",
                                                    spin, static_cast<int>(observer), r, theta, x, y, found,
                                                    exact.delay, static_cast<int>(exact.fate))};
                            };
                            look(in_double, a.delay, 1), look(in_float, b.delay, 1);
                            ++rays;
                        }
                }
    fmt::print(
        "light times of {} rays about rotating holes: core64 off by at most {:.1e} of them or r_s ({}),\n  core32 "
        "{:.1e} ({})\n",
        rays, in_double.off, in_double.where, in_float.off, in_float.where);
    constexpr double
        kSteps = 1e-4,
        kFloat = 3e-4;  // quadrature at the steps of the ray's own sixth order; and a float's bits of the logarithms
    CHECK(rays > 10000);
    CHECK(in_double.off < kSteps);
    CHECK(in_float.off < kFloat);
}

}  // namespace
