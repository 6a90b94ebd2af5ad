// The edge of a rotating hole's shadow: which rays come out, to a microradian, for every spin up to the greatest.
#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "reference/frame_tracer.h"
#include "render/frame_tables.h"
#include "shadercore/core_trace.h"
#include "support/costly.h"
#include "support/depth.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

// Between a place in the shadow and one beside it, px from the left.
template <class Escapes>
double edge(const Escapes& escapes, double inside, double outside) {
    for (int i = 0; i < 45; ++i) {
        const double middle = 0.5 * (inside + outside);
        (escapes(middle) ? outside : inside) = middle;
    }
    return inside;
}

TEST_CASE("kerr edge: rays further than a microradian from it end as the reference's" * test::costly()) {
    constexpr double kInDouble = 1e-6;  // rad: what is promised
    constexpr double kInFloat = 8e-6;   // what rounding of the ray's constants makes of it next to the greatest spin
    constexpr int kMostSteps = 64, kWidth = 1920, kHeight = 1080;
    double in_double = 0, in_float = 0;
    int edges = 0, steps = 0;
    for (const double spin : {0.5, 0.9, 0.998, 0.9999})
        for (const double r : {3.0, 10.0})
            for (const double theta : {0.5 * M_PI, 1.3}) {
                Scene scene;
                scene.spacetime = {"kerr", {{"spin", spin}}};
                CameraSpec& camera = scene.camera;
                camera.r = r, camera.theta = theta, camera.observer = ObserverKind::kZamo;
                camera.width = kWidth, camera.height = kHeight, camera.plane_width = 9 / r * camera.focal_distance;
                FrameTables tables;
                REQUIRE(tables.update(scene));
                const CoreInput input = tables.core_input();
                const auto tracer = *reference::FrameTracer::make(scene);
                const double pixel = 9 / r / kWidth;
                for (const double y :
                     by_depth(std::vector{380.0}, std::vector{540.0, 450.0, 380.0}, {540.0, 450.0, 380.0}))
                    for (const double side : {-1.0, 1.0}) {
                        const auto true_one = [&](double x) { return tracer.ray(x, y)->fate() == Fate::kEscaped; };
                        const auto core = [&](auto trace) {
                            return [&, trace](double x) {
                                return trace(input, x - 0.5 * kWidth, 0.5 * kHeight - y).fate == Fate::kEscaped;
                            };
                        };
                        const double inside = 0.5 * kWidth + side * 60, outside = 0.5 * kWidth + side * 955;
                        if (true_one(inside) || !true_one(outside))
                            continue;  // the shadow is wider than the frame, or elsewhere
                        const double at = edge(true_one, inside, outside);
                        in_double =
                            std::max(in_double, pixel * std::fabs(edge(core(trace_core64), inside, outside) - at));
                        in_float =
                            std::max(in_float, pixel * std::fabs(edge(core(trace_core32), inside, outside) - at));
                        for (const double further : {1e-6, 1e-5, 1e-4})
                            steps = std::max(steps, trace_core64(input, at + side * further / pixel - 0.5 * kWidth,
                                                                 0.5 * kHeight - y)
                                                        .steps);
                        ++edges;
                    }
            }
    fmt::print(
        "{} edges: core64 off by at most {:.1e} rad, core32 {:.1e} rad; next to them rays take at most {} steps\n",
        edges, in_double, in_float, steps);
    CHECK(edges > by_depth(20, 60, 60));
    CHECK(in_double <= kInDouble);
    CHECK(in_float <= kInFloat);
    CHECK(steps < kMostSteps);
}

}  // namespace
