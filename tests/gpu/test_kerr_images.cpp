// Images of the disc of high order about a rotating hole, where rays wind long before they reach it: the shader's text in double.
#include <cmath>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "reference/frame_tracer.h"
#include "render/frame_tables.h"
#include "scenefile/scene_file.h"
#include "shadercore/core_trace.h"
#include "support/depth.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kInner = 1, kOuter = 30;

struct Met {
    int number = 0;  // of the ray's crossings, the first with the disc
    Vec3 place;
};

Met met_by(const reference::FrameTracer& tracer, double x, double y) {
    const auto ray = tracer.ray(x, y);
    int k = 0;
    for (const auto& c : ray->crossings(16))
        if (++k; c.r >= kInner && c.r <= kOuter) return {k, c.r * Vec3{std::cos(c.phi), std::sin(c.phi), 0}};
    return {};
}

TEST_CASE("kerr images: of any order") {
    constexpr double kMoves = 1e-3;     // of a pixel: where the image of a place may be
    constexpr double kFromEdge = 0.03;  // px, 1e-6 rad: closer to the shadow's edge 64 steps need not do
    Scene scene;  // the side that turns towards the camera, where an image is not much thinner than the one before
    scene.spacetime = {"kerr", {{"spin", 0.998}}};
    CameraSpec& camera = scene.camera;
    camera.r = 10, camera.theta = 1.536, camera.yaw = -0.1016, camera.observer = ObserverKind::kZamo;
    camera.width = 120, camera.height = 10, camera.plane_width = 4e-3 * camera.focal_distance;
    scene.disc.emplace().inner = kInner, scene.disc->outer = kOuter;
    FrameTables tables;
    REQUIRE(tables.update(scene));
    const CoreInput input = tables.core_input();
    const auto tracer = *reference::FrameTracer::make(scene);
    int late = 0, latest = 0, missed = 0;
    double worst = 0;
    for (int i = 0; i < 4000; i += by_depth(4, 1, 1)) {  // across the edge, some hundredths of a pixel apart
        const double x = 90 + 0.004 * i, y = 5.5;
        const Met met = met_by(tracer, x, y);
        if (met.number < 5 || tracer.ray(x + kFromEdge, y)->fate() == Fate::kCaptured ||
            tracer.ray(x - kFromEdge, y)->fate() == Fate::kCaptured)
            continue;
        ++late, latest = std::max(latest, met.number);
        // From the centre, upward.
        const RayPixel drawn = trace_core64(input, x - 0.5 * camera.width, 0.5 * camera.height - y);
        missed += drawn.fate != Fate::kHit;
        const Met beside = met_by(tracer, x + 1e-6, y);
        if (beside.number != met.number) continue;
        worst = std::max(
            worst, length(Vec3{drawn.u, drawn.v, drawn.w} - met.place) / (1e6 * length(beside.place - met.place)));
    }
    fmt::print("{} rays meet the disc at their fifth crossing or later, up to the {}th: {} missed, place {:.1e} px\n",
               late, latest, missed, worst);
    CHECK(missed == 0);
    CHECK(late > by_depth(12, 50, 50));
    CHECK(latest >= 5);
    CHECK(worst <= kMoves);
}

// The light rings about this hole lie just inside of the disc: light that winds there crosses the plane beside the rim, more often
// than a shader keeps crossings, before it meets the disc on its way out.
TEST_CASE("kerr images: behind crossings beside the rim") {
    Scene scene = *load_scene("kerr-newman");
    CameraSpec& camera = scene.camera;
    camera.width = 1920, camera.height = 1080;
    FrameTables tables;
    REQUIRE(tables.update(scene));
    const auto tracer = *reference::FrameTracer::make(scene);
    int late = 0;
    for (int i = -6; i <= 80; ++i) {  // next to the shadow's edge
        const double x = 1133.5 + 1e-3 * i, y = 810.5;
        int beside = 0;
        for (const auto& c : tracer.ray(x, y)->crossings(16)) {
            if (c.r >= scene.disc->inner && c.r <= scene.disc->outer) break;
            ++beside;
        }
        late += beside >= 4;
        CAPTURE(i);
        CHECK(trace_core64(tables.core_input(), x - 0.5 * camera.width, 0.5 * camera.height - y).hit ==
              tracer.pixel(x, y, false).hit);
    }
    CHECK(late > 10);
}

}  // namespace
