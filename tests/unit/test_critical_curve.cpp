// The critical curve: against Synge's formula (1966), and against traced rays: on its two sides they end apart, 0.01 px away from it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "observer/critical_curve.h"
#include "observer/pose.h"
#include "reference/frame_tracer.h"
#include "scene/projection.h"
#include "spacetime/registry.h"

namespace {

using namespace nullscope;

Scene scene_of(const char* metric, MetricParameters parameters = {}) {
    Scene scene;
    scene.spacetime = {metric, std::move(parameters)};
    return scene;
}

std::vector<PictureLine> curve_of(const Scene& scene) {
    const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    REQUIRE(spacetime);
    return critical_curve(**spacetime, scene.camera, scene.light);
}

constexpr double kAside = 0.01;  // px

// Of some points within the picture; at least `least` of them.
void check_sides(const Scene& scene, int least) {
    const auto tracer = reference::FrameTracer::make(scene);
    REQUIRE(tracer);
    int checked = 0;
    for (const PictureLine& line : curve_of(scene)) {
        for (std::size_t i = 1; i + 1 < line.size(); i += 7) {
            const double x = line[i][0], y = line[i][1];
            if (x < 0 || y < 0 || x > scene.camera.width || y > scene.camera.height) continue;
            const double dx = line[i + 1][0] - line[i - 1][0], dy = line[i + 1][1] - line[i - 1][1],
                         scale = kAside / std::hypot(dx, dy);
            CAPTURE(x);
            CAPTURE(y);
            const auto one = tracer->ray(x - dy * scale, y + dx * scale)->fate(),
                       other = tracer->ray(x + dy * scale, y - dx * scale)->fate();
            CHECK(one != other);
            CHECK((one == Fate::kEscaped || other == Fate::kEscaped));
            ++checked;
        }
    }
    CHECK(checked >= least);
}

TEST_CASE("critical curve: a circle of Synge's angle about a hole that the camera rests at") {
    Scene scene = scene_of("schwarzschild");
    scene.camera.plane_width = 20.0;
    for (const double r : {1.2, 1.5, 1.6, 3.0, 15.0, 1e4}) {
        CAPTURE(r);
        scene.camera.r = r;
        scene.camera.yaw = r < 1.6 ? std::numbers::pi : 0.0;  // from inside the photon sphere it lies about the sky
        const double sine = 1.5 * std::sqrt(3.0) * std::sqrt(1.0 - 1.0 / r) / r;
        const auto lines = curve_of(scene);
        if (r == 1.5) continue;  // a great circle
        REQUIRE(lines.size() == 1);
        CHECK(std::hypot(lines[0].front()[0] - lines[0].back()[0], lines[0].front()[1] - lines[0].back()[1]) < 1e-6);
        for (const auto& [x, y] : lines[0]) {
            const Vec3 d = normalized(pixel_direction(scene.camera, x, y));
            CHECK(std::fabs(std::hypot(d.x, d.y) / sine - 1.0) <= 1e-9);
        }
    }
}

TEST_CASE("critical curve: traced rays end apart on its sides, about holes without spin and of cameras that move") {
    Scene scene = scene_of("schwarzschild");
    check_sides(scene, 12);
    scene.camera.velocity = {0.2, -0.3, 0.6}, scene.camera.plane_width = 4.0;
    check_sides(scene, 8);
    scene.light.aberration = false;
    check_sides(scene, 12);
    scene.light.aberration = true;
    scene.camera.r = 4.0, scene.camera.yaw = 0.5, scene.camera.pitch = 0.2;
    scene.camera.observer = ObserverKind::kOrbit;
    check_sides(scene, 12);
    scene.camera.velocity = {-0.99, 0.05, 0.0}, scene.camera.yaw = 0.0;
    check_sides(scene, 6);
    scene.camera.velocity = {};
    scene.camera.observer = ObserverKind::kRain;
    for (const double r : {1.4, 1.0, 0.6}) {
        CAPTURE(r);
        scene.camera.r = r, scene.camera.plane_width = 8.0;
        check_sides(scene, 12);
    }
}

TEST_CASE("critical curve: of other metrics with a photon sphere") {
    check_sides(scene_of("reissner-nordstrom", {{"charge", 0.8}}), 12);
    check_sides(scene_of("janis-newman-winicour"), 12);
    check_sides(scene_of("neutron-star", {{"radius", 1.3}}), 12);
    check_sides(scene_of("ellis"), 12);
    CHECK(curve_of(scene_of("neutron-star", {{"radius", 2.0}})).empty());
    CHECK(curve_of(scene_of("minkowski")).empty());
    CHECK(curve_of(scene_of("reissner-nordstrom", {{"charge", 1.04}})).size() == 1);
    CHECK(curve_of(scene_of("reissner-nordstrom", {{"charge", 1.5}})).empty());
    Scene straight = scene_of("schwarzschild");
    straight.light.lensing = false;
    CHECK(curve_of(straight).empty());
}

TEST_CASE("critical curve: the shadow's edge about rotating holes is that of traced rays") {
    for (const double spin : {1e-4, 0.6, 0.998}) {
        CAPTURE(spin);
        Scene scene = scene_of("kerr", {{"spin", spin}});
        check_sides(scene, 12);
        scene.camera.r = 5.0, scene.camera.theta = 1.0, scene.camera.velocity = {0.3, 0.2, -0.6};
        scene.camera.plane_width = 3.0;
        check_sides(scene, 6);
        scene.camera.theta = 0.0;  // on the axis
        check_sides(scene, 6);
    }
    check_sides(scene_of("kerr-newman", {{"spin", 0.6}, {"charge", 0.7}}), 12);
}

TEST_CASE("critical curve: from between the orbits of light, and from inside a rotating hole") {
    Scene scene = scene_of("kerr", {{"spin", 0.9}});
    scene.camera.r = 1.1, scene.camera.theta = std::numbers::pi / 2, scene.camera.plane_width = 8.0;
    for (const auto observer : {ObserverKind::kZamo, ObserverKind::kCarter, ObserverKind::kRain})
        for (const double yaw : {0.0, 1.6, 3.1, -1.6}) {
            scene.camera.observer = observer, scene.camera.yaw = yaw;
            CAPTURE(yaw);
            check_sides(scene, yaw == 1.6 || yaw == -1.6 ? 2 : 0);
        }
    scene.camera.r = 0.6, scene.camera.observer = ObserverKind::kRain, scene.camera.yaw = 0.0;
    check_sides(scene, 6);
}

TEST_CASE("critical curve: what is behind the camera is left out") {
    Scene scene = scene_of("schwarzschild");
    scene.camera.yaw = std::numbers::pi;
    CHECK(curve_of(scene).empty());
    scene.camera.r = 1.5, scene.camera.yaw = 0.3;
    const auto lines = curve_of(scene);
    CHECK(lines.size() >= 1);
    CHECK(std::ranges::all_of(lines, [](const PictureLine& line) { return line.size() > 1; }));
}

}  // namespace
