// What tests of bodies about a rotating hole share.
#pragma once
#include <memory>
#include <optional>

#include "reference/kerr_bodies.h"
#include "reference/kerr_ray.h"
#include "reference/metric.h"

namespace nullscope::test {

constexpr double kOnSurface = 1e-10;  // of the body's size

inline Scene spinning(double spin) {
    Scene scene;
    scene.spacetime = {"kerr", {{"spin", spin}}};
    scene.camera.theta = 1.3, scene.camera.phi = 0.2, scene.camera.width = 40, scene.camera.height = 30;
    return scene;
}

inline std::unique_ptr<reference::Metric> metric_of(const Scene& scene) {
    return std::move(*reference::make_metric(scene.spacetime));
}

struct Met {
    reference::KerrRay ray;
    std::optional<reference::BodyHit> hit;
};
inline Met met(const Scene& scene, const reference::Metric& metric, const reference::KerrStart& start) {
    const reference::Bodies bodies(scene, metric);
    reference::BodyWatch watch(bodies, scene.light.delay);
    Met found{reference::trace_kerr(scene.spacetime.parameters.at("spin"), start, 16, watch.watch()), {}};
    found.hit = watch.hit();
    return found;
}

}  // namespace nullscope::test
