#include "compare/hard_parts.h"

#include <cmath>
#include <map>
#include <utility>

#include "observer/spin_frame.h"
#include "spacetime/axial_metric.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/registry.h"

namespace nullscope {
namespace {

struct Hole {
    std::string label, metric;
    std::map<std::string, double> parameters;
};

// A ray of the reference is integrated, some 0.2 ms: frames are smaller than those of other metrics.
Scene rotating_frame_of(const Hole& hole, double r, double theta, double yaw, double fov) {
    Scene scene = hard_view(hard_frame({hole.metric, hole.parameters}, 33, 19), r, yaw, fov);
    scene.camera.observer = ObserverKind::kZamo, scene.camera.theta = theta;
    return scene;
}

void places(std::vector<HardCase>& list, const Hole& hole, const AxialMetric& metric) {
    const double wide = 60 * kDegree, horizon = metric.outer_horizon();
    add_case(list, hole.label, "on the axis", "there is no azimuth", rotating_frame_of(hole, 10, 0, 0, wide));
    add_case(list, hole.label, "1e-9 off the axis", "the azimuth is a ratio of small numbers",
             rotating_frame_of(hole, 10, 1e-9, 0, wide));
    Scene plane = rotating_frame_of(hole, 10, M_PI / 2, 0, wide);
    plane.disc = ring(1.02 * horizon, 6);
    add_case(list, hole.label, "in the disc's plane", "rays in the plane never cross it", plane);
    plane.camera.theta -= 1e-6;
    add_case(list, hole.label, "1e-6 above the disc's plane", "crossings at grazing incidence", plane);
    Scene edge = rotating_frame_of(hole, 20, 1.4, 0, 30 * kDegree);
    edge.disc = ring(1.02 * horizon, 6);
    add_case(list, hole.label, "disc down to the horizon", "its images pile up along the shadow", edge);
    for (const auto& [view, yaw] : kViews) {
        add_case(list, hole.label, fmt::format("1e-4 above the horizon, {}", view),
                 "frame dragging grows without bound",
                 rotating_frame_of(hole, horizon * (1 + 1e-4), 1.3, yaw, 100 * kDegree));
        add_case(list, hole.label, fmt::format("at light's own orbit, {}", view), "rays that wind start here",
                 rotating_frame_of(hole, light_orbit(metric), M_PI / 2, yaw, 100 * kDegree));
    }
    add_case(list, hole.label, "in the ergosphere", "no observer can be at rest here",
             rotating_frame_of(hole, 0.5 * (horizon + static_limit(metric, 1.5)), 1.5, 0.7, 100 * kDegree));
    add_case(list, hole.label, "from 1e6 r_s", "the hole spans microradians: impact parameters are small differences",
             rotating_frame_of(hole, 1e6, 1.2, 0, 8e-6));
}

void rotating_motions(std::vector<HardCase>& list, const Hole& hole, const AxialMetric& metric) {
    add_motions(list, hole.label, rotating_frame_of(hole, 6, 1.1, 0, 90 * kDegree),
                {{-0.999, 0, 0}, {0, 0.3, 0.9}, {0.999, 0, 0}});
    const double outer = metric.outer_horizon(), inner = metric.inner_horizon();
    for (const auto& [where, r] : {std::pair{"on the horizon", outer}, {"between the horizons", 0.5 * (outer + inner)}})
        for (const auto& [view, yaw] : {std::pair{"inwards", 0.0}, {"outwards", M_PI}}) {
            Scene scene = rotating_frame_of(hole, r, 1.2, yaw, 100 * kDegree);
            scene.camera.observer = ObserverKind::kRain;
            add_case(list, hole.label, fmt::format("rain {}, {}", where, view), "the azimuth diverges at the horizon",
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
        const AxialMetric& metric = *spacetime->axial();
        places(list, hole, metric);
        rotating_motions(list, hole, metric);
    }
    return list;
}

}  // namespace nullscope
