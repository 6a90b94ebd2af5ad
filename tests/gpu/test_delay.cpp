// The delay map and what is seen late, in the shader's text and on the GPU, against the reference.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "support/gpu_session.h"
#include "reference/frame_tracer.h"
#include "render/frame_tables.h"
#include "scene/scene_file.h"

using namespace nullscope;

TEST_CASE("light time: the shader's text against the reference, on discs about holes with and without charge, near and far") {
    constexpr const char* kMetrics[] = {"schwarzschild", "reissner-nordstrom"};
    double worst = 0, worst_float = 0;
    std::string place;
    for (const char* name : kMetrics)
        for (const double r : {1.2, 1.5, 4.0, 25.0, 1000.0})
            for (const double theta : {20.0, 85.0}) {
                Scene scene;
                scene.spacetime.metric = name;
                if (scene.spacetime.metric == "reissner-nordstrom") scene.spacetime.parameters["charge"] = 1.0;
                scene.camera.r = r, scene.camera.theta = theta * M_PI / 180, scene.camera.width = 48, scene.camera.height = 27;
                scene.camera.plane_width = 2 * std::tan(std::min(1.2, 20 / r));
                scene.disc.emplace();
                scene.disc->inner = 1.6, scene.disc->outer = 12, scene.disc->flow = DiscFlowKind::kKepler;
                FrameTables tables;
                REQUIRE(tables.update(scene));
                const CoreInput input = tables.core_input(scene);
                auto tracer = *reference::FrameTracer::make(scene);
                for (int y = 0; y < 27; ++y)
                    for (int x = 0; x < 48; ++x) {
                        const auto exact = tracer.pixel(x + 0.5, y + 0.5);
                        if (exact.fate != Fate::kHit) continue;
                        const auto in_double = trace_core64(input, x - 23.5, 13 - y), in_float = trace_core32(input, x - 23.5, 13 - y);
                        if (in_double.fate != Fate::kHit || in_float.fate != Fate::kHit || in_float.order != exact.order) continue;   // the rims
                        const double scale = std::max(exact.delay, 5.0), off = std::fabs(in_float.delay - exact.delay) / scale;
                        worst = std::max(worst, std::fabs(in_double.delay - exact.delay) / scale);
                        if (off > worst_float) place = fmt::format("{}, camera {} r_s, {} degrees, at {:.3f} r_s", name, r, theta, std::hypot(exact.u, exact.v));
                        worst_float = std::max(worst_float, off);
                    }
            }
    fmt::print("light time to the disc: core64 off by at most {:.2g}, core32 {:.2g} of it, or of 5 r_s ({})\n", worst, worst_float, place);
    // The map's zeta is off by 1e-7, which far out is r^2 times that and next to the turning point the slope's error over zeta.
    constexpr double kMap = 1e-5, kFloat = 2e-5;
    CHECK(worst < kMap);
    CHECK(worst_float < kFloat);
}
