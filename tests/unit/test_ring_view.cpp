// Zooms into the photon ring: what a deep view is replaced by, and what is refused.
#include "observer/ring_view.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <memory>
#include <string>

#include "observer/critical_light.h"
#include "observer/observer.h"
#include "observer/pose.h"
#include "plan/frame_plan.h"
#include "scenefile/scene_edit.h"
#include "scenefile/scene_file.h"
#include "scenefile/scene_writer.h"
#include "spacetime/registry.h"
#include "support/metrics.h"
#include "table/ray_family.h"

namespace {

using namespace nullscope;

// A picture's corner is some 700 px from its middle, where a turn of the swept angle is a/700 a pixel: a thousandth of that.
constexpr double kJump_px = 1e-3, kCorner_px = 700;

CameraSpec zoomed(double r, double depth, ObserverKind observer = ObserverKind::kStatic) {
    CameraSpec camera;
    camera.r = r, camera.observer = observer;
    camera.zoom = ZoomSpec{depth, 0.7};
    return camera;
}

Result<RingView> view_of(const std::string& metric, const CameraSpec& camera,
                         const std::map<std::string, double>& parameters = {}) {
    return ring_view(**make_spacetime(metric, parameters), camera, {});
}

struct RingViewWorld {
    std::string metric;
    MetricParameters parameters;
};

MetricParameters lapse(const char* formula) {
    MetricParameters parameters;
    parameters.formulas["A"] = formula;
    return parameters;
}

const RingViewWorld kWorlds[] = {{"schwarzschild", {}},
                                 {"reissner-nordstrom", {{"charge", 0.9}}},
                                 {"reissner-nordstrom", {{"charge", 1.0}}},
                                 {"reissner-nordstrom", {{"charge", 1.03}}},
                                 {"janis-newman-winicour", {}},
                                 {"neutron-star", {}},
                                 {"ellis", {}},
                                 {"dneg-wormhole", {{"length", 0.0}}},
                                 {"formula", lapse("1 - r^2/(r^2 + 0.35^2)^(3/2)")},
                                 {"formula", lapse("1 - 1/r - 0.0002*r^2/3")}};

}  // namespace

TEST_CASE("ring view: a view that is a turn less deep shows the same, about every metric") {
    int views = 0;
    for (const RingViewWorld& world : kWorlds) {
        CAPTURE(world.metric);
        const auto made = make_spacetime(world.metric, world.parameters);
        if (!made) continue;
        const auto metric = test::spherical(*made);
        const std::shared_ptr<const DeflectionTable> table =
            metric->chi() != nullptr ? std::make_shared<const DeflectionTable>(*metric) : nullptr;
        const auto sphere = open_photon_sphere(*metric);
        if (!sphere) continue;
        for (const double r : {sphere->radius * (1 + 1e-6), sphere->radius * 1.1, 3.0, 20.0, 1e4})
            for (const ObserverKind observer : {ObserverKind::kStatic, ObserverKind::kRain}) {
                CameraSpec camera = zoomed(r, 60, observer);
                const auto view = ring_view(*metric, camera, {});
                if (!view) continue;
                REQUIRE(view->turns > 0);
                const double corner = 0.5 * std::hypot(camera.width, camera.height) * view->camera.pixel();
                const double rate =
                    2 * M_PI * view->turns / (60 + std::log(view->camera.plane_width / camera.plane_width));
                const auto frame = observer_of(*metric, camera)->frame;
                const RayFamily family(metric, table, r, frame, 1e-20, M_PI);
                const double root_v = metric->root_v(r) / sphere->q_crit,
                             scale = family.critical_sine() * (metric->barrier() ? 1 - root_v * root_v : 1);
                CHECK(corner <= kSimilar * scale * (1 + 1e-9));
                CHECK(corner > kSimilar * scale * std::exp(-2 * M_PI / rate) * (1 - 1e-9));
                for (const Segment segment : {Segment::kSky, Segment::kCaptured})
                    for (const double delta : {kSimilar * scale, 1e-4 * kSimilar * scale}) {
                        const double near = family.ray(segment, delta).phi_end,
                                     deep = family.ray(segment, delta * std::exp(-2 * M_PI / rate)).phi_end;
                        const double turns = (deep - near) / (2 * M_PI);
                        CAPTURE(r);
                        CAPTURE(delta);
                        const double whole = std::round(turns);
                        CHECK(whole >= 1);
                        CHECK(whole <= 2);  // of light that comes back through the photon sphere
                        CHECK(std::fabs(turns - whole) * 2 * M_PI < kJump_px * rate / kCorner_px);
                        ++views;
                    }
            }
    }
    CHECK(views > 200);
}

TEST_CASE("ring view: the middle is the critical direction, the depth what is left of it") {
    const auto hole = *make_spacetime("schwarzschild", {});
    for (const double depth : {0.0, 5.0, 17.0, 40.0, 690.0}) {
        CameraSpec camera = zoomed(20, depth);
        camera.velocity = {0.1, 0.5, -0.3};
        camera.roll = 0.4;
        const auto view = ring_view(*hole, camera, {});
        REQUIRE(view);
        CHECK(view->turns == (depth < 20 ? 0 : std::floor(view->turns)));
        CHECK(std::fabs(std::log(view->camera.plane_width / camera.plane_width) - 2 * M_PI * view->turns + depth) <
              1e-9);
        CHECK(std::fabs(view->lag - view->turns * 2 * M_PI * 1.5 * std::sqrt(3.0)) < 1e-9 * (1 + view->lag));
        const Vec3 seen = CriticalLight::make(*hole, view->camera, {})->direction(0.7);
        CHECK(std::hypot(seen.x, seen.y) < 1e-14);
        CHECK(seen.z < 0);
    }
}

TEST_CASE("ring view: left and above, as docs/scenes.md says") {
    const auto right_of = [](double angle) {
        CameraSpec camera = zoomed(20, 0);
        camera.zoom->angle = angle;
        const auto view = view_of("schwarzschild", camera);
        return Vec3{view->camera.yaw, view->camera.pitch, 0};
    };
    CHECK(right_of(0).x < -0.1);
    CHECK(right_of(M_PI / 2).y > 0.1);
}

TEST_CASE("ring view: refusals are one line each") {
    const auto refused = [](const Result<RingView>& view) { return view ? std::string() : view.error().message(); };
    for (const std::string& message : {refused(view_of("minkowski", zoomed(20, 5))),
                                       refused(view_of("neutron-star", zoomed(20, 5), {{"radius", 3.0}}))}) {
        CAPTURE(message);
        CHECK(message.starts_with("zoom: "));
        CHECK(message.find('\n') == std::string::npos);
    }
    const auto deep = without_zoom(**make_spacetime("schwarzschild", {}), zoomed(20, 25), {});
    REQUIRE_FALSE(deep);
    CHECK(deep.error().message().find("zoom.depth") != std::string::npos);
    CHECK(without_zoom(**make_spacetime("schwarzschild", {}), zoomed(20, 15), {}));
}

TEST_CASE("ring view: a scene file has it, a path moves it, a line of text keeps it") {
    const auto scene = parse_scene(
        "[zoom]\ndepth = 3\nangle = 45\n[path]\nkind = \"keys\"\n[[path.key]]\nframe = 0\n[[path.key]]\nframe = "
        "10\ndepth = 13\n",
        "zoom.toml", {});
    REQUIRE_MESSAGE(scene, (scene ? "" : scene.error().message()));
    REQUIRE(scene->camera.zoom);
    CHECK(scene->camera.zoom->depth == 3);
    CHECK(scene->path->keys[1].camera.zoom->depth == 13);
    CHECK(scene->path->keys[1].camera.zoom->angle == scene->camera.zoom->angle);
    const auto again = parse_scene(scene_file_text(*scene, {}), "zoom.toml", {});
    REQUIRE(again);
    CHECK(again->camera == scene->camera);
    CHECK(again->path == scene->path);
    const auto view = camera_of_view(view_line(scene->camera), *scene);
    REQUIRE_MESSAGE(view, (view ? "" : view.error().message()));
    CHECK(view->zoom == scene->camera.zoom);
}
