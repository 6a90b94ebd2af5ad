// Isoradials: every point, traced again as a pixel's ray, meets its ring; from above they are circles; the second image lies inside.
#include <doctest/doctest.h>

#include <cmath>

#include "reference/isoradial.h"

namespace {

using namespace nullscope;

Scene scene_from(double theta_deg) {
    Scene scene;
    scene.camera.r = 60;
    scene.camera.theta = theta_deg * M_PI / 180;
    scene.camera.plane_width = 2 * std::tan(0.3);
    scene.camera.focal_distance = 1;
    scene.camera.width = 800;
    scene.camera.height = 600;
    scene.disc.emplace().inner = 2.9;
    scene.disc->outer = 20;
    return scene;
}

constexpr double kTolerance = 1e-9;  // of the ring's radius: TOMS 748 stops at 48 of 53 bits of the angle

TEST_CASE("isoradials meet their rings") {
    for (const double theta : {80.0, 45.0, 100.0}) {
        const Scene scene = scene_from(theta);
        const auto tracer = reference::FrameTracer::make(scene);
        REQUIRE(tracer);
        for (const double r : {3.0, 5.0, 15.0})
            for (const int k : {1, 2}) {
                const auto curve = reference::isoradial(scene, r, k, 60);
                REQUIRE(curve);
                CHECK(curve->size() == 60);
                for (const auto& [x, y] : *curve) {
                    const auto ray = tracer->ray(x, y);
                    const double met = ray->crossings(k).back().r;
                    CHECK(std::abs(met / r - 1) <= kTolerance);
                }
            }
    }
}

TEST_CASE("isoradials from above are circles, the next image inside the first") {
    const Scene scene = scene_from(0.0);
    const auto first = reference::isoradial(scene, 5.0, 1, 24), second = reference::isoradial(scene, 5.0, 2, 24);
    REQUIRE(first);
    REQUIRE(second);
    const auto radius = [](const std::array<double, 2>& p) { return std::hypot(p[0] - 400, p[1] - 300); };
    for (const auto* curve : {&*first, &*second})
        for (const auto& point : *curve) CHECK(std::abs(radius(point) / radius(curve->front()) - 1) <= kTolerance);
    CHECK(radius(second->front()) < radius(first->front()));
}

}  // namespace
