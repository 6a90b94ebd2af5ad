#include "compare/hard_rotating.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "spacetime/axial_metric.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/registry.h"
#include "spacetime/spin_frame.h"

namespace nullscope {
namespace {

constexpr double kDegree = M_PI / 180;

struct Hole {
    std::string label, metric;
    std::map<std::string, double> parameters;
};

// A ray of the reference is integrated, some 0.2 ms: frames are smaller than those of other metrics.
Scene frame_of(const Hole& hole, double r, double theta, double yaw, double fov) {
    Scene scene;
    scene.spacetime = {hole.metric, hole.parameters};
    scene.sky.kind = SkyKind::kBlack;
    scene.camera.observer = ObserverKind::kZamo;
    scene.camera.width = 33;
    scene.camera.height = 19;
    scene.camera.r = r, scene.camera.theta = theta, scene.camera.yaw = yaw;
    scene.camera.plane_width = 2 * std::tan(0.5 * fov);
    return scene;
}

void add(std::vector<HardCase>& list, const Hole& hole, const std::string& what, const std::string& why, Scene scene) {
    scene.name = fmt::format("{}, {}", hole.label, what);
    list.push_back({scene.name, why, scene});
}

void disc(Scene& scene, double inner, double outer = 6) {
    scene.disc = DiscSpec{};
    scene.disc->inner = inner, scene.disc->outer = outer;
}

void places(std::vector<HardCase>& list, const Hole& hole, const AxialMetric& metric) {
    const double wide = 60 * kDegree, horizon = metric.outer_horizon();
    add(list, hole, "on the axis", "there is no azimuth", frame_of(hole, 10, 0, 0, wide));
    add(list, hole, "1e-9 off the axis", "the azimuth is a ratio of small numbers", frame_of(hole, 10, 1e-9, 0, wide));
    Scene plane = frame_of(hole, 10, M_PI / 2, 0, wide);
    disc(plane, 1.02 * horizon);
    add(list, hole, "in the disc's plane", "rays in the plane never cross it", plane);
    plane.camera.theta -= 1e-6;
    add(list, hole, "1e-6 above the disc's plane", "crossings at grazing incidence", plane);
    Scene edge = frame_of(hole, 20, 1.4, 0, 30 * kDegree);
    disc(edge, 1.02 * horizon);
    add(list, hole, "disc down to the horizon", "its images pile up along the shadow", edge);
    for (const auto& [look, yaw] : {std::pair{"inwards", 0.0}, {"across", M_PI / 2}, {"outwards", M_PI}}) {
        add(list, hole, fmt::format("1e-4 above the horizon, {}", look), "frame dragging grows without bound",
            frame_of(hole, horizon * (1 + 1e-4), 1.3, yaw, 100 * kDegree));
        add(list, hole, fmt::format("at light's own orbit, {}", look), "rays that wind start here",
            frame_of(hole, light_orbit(metric), M_PI / 2, yaw, 100 * kDegree));
    }
    add(list, hole, "in the ergosphere", "nobody is at rest here",
        frame_of(hole, 0.5 * (horizon + static_limit(metric, 1.5)), 1.5, 0.7, 100 * kDegree));
    add(list, hole, "from 1e6 r_s", "the hole spans microradians: impact parameters are small differences",
        frame_of(hole, 1e6, 1.2, 0, 8e-6));
}

void motions(std::vector<HardCase>& list, const Hole& hole, const AxialMetric& metric) {
    for (const Vec3 v : {Vec3{-0.999, 0, 0}, {0, 0.3, 0.9}, {0.999, 0, 0}}) {
        Scene scene = frame_of(hole, 6, 1.1, 0, 90 * kDegree);
        scene.camera.velocity = v;
        add(list, hole, fmt::format("moving at ({}, {}, {}) c", v.x, v.y, v.z), "aberration on top", scene);
    }
    const double outer = metric.outer_horizon(), inner = metric.inner_horizon();
    for (const auto& [where, r] : {std::pair{"on the horizon", outer}, {"between the horizons", 0.5 * (outer + inner)}})
        for (const auto& [look, yaw] : {std::pair{"inwards", 0.0}, {"outwards", M_PI}}) {
            Scene scene = frame_of(hole, r, 1.2, yaw, 100 * kDegree);
            scene.camera.observer = ObserverKind::kRain;
            add(list, hole, fmt::format("rain {}, {}", where, look), "the azimuth winds without end at the horizon",
                scene);
        }
}

}  // namespace

std::vector<HardCase> hard_rotating_cases() {
    const std::vector<Hole> holes = {{"a = 0.9", "kerr", {{"spin", 0.9}}},
                                     {"a = Q = 0.6", "kerr-newman", {{"spin", 0.6}, {"charge", 0.6}}},
                                     {"a = 0.05, Q = 0.99", "kerr-newman", {{"spin", 0.05}, {"charge", 0.99}}}};
    std::vector<HardCase> list;
    for (const Hole& hole : holes) {
        const auto spacetime = *make_spacetime(hole.metric, hole.parameters);
        places(list, hole, *spacetime->axial());
        motions(list, hole, *spacetime->axial());
    }
    return list;
}

}  // namespace nullscope
