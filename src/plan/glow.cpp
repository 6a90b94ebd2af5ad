#include "plan/glow.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/bodies.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {

std::optional<LapseForm> lapse_form(const Spacetime& spacetime) {
    if (!spacetime.bends_light()) return LapseForm{0, 0};
    if (spacetime.rotates() || spacetime.by_proper_length() || spacetime.orbit_equation() == nullptr) return {};
    const double out =
        std::max({1.0, spacetime.horizon_radius().value_or(0.0), spacetime.surface_radius().value_or(0.0)});
    const auto less = [&](double r) { return (1.0 - spacetime.lapse_squared(r)) * r; };  // sum - product/r
    const double near = 1.5 * out, far = 4.0 * out, product = (less(far) - less(near)) / (1.0 / near - 1.0 / far),
                 sum = less(near) + product / near;
    for (const double r : {1.1 * out, 2.0 * out, 10.0 * out}) {
        constexpr double kAlike = 1e-12;
        if (!(std::fabs(1.0 - sum / r + product / (r * r) - spacetime.lapse_squared(r)) < kAlike)) return {};
    }
    return LapseForm{sum, product};
}

std::vector<SceneFault> glow_faults(const Spacetime& spacetime, const Scene& scene) {
    std::vector<SceneFault> faults;
    if (spacetime.rotates() || lapse_form(spacetime)) return faults;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        if (scene.bodies[i].material.temperature_K)
            faults.push_back(
                {body_section(scene, i) + ".temperature",
                 fmt::format("metric \"{}\" does not say how light of bodies is shifted", spacetime.name()),
                 "no temperature, or a metric with A = 1 - a/r + b/r^2 and B = 1/A, or a rotating hole"});
    return faults;
}

Status check_glow(const Spacetime& spacetime, const Scene& scene) {
    const auto faults = glow_faults(spacetime, scene);
    if (faults.empty()) return Done{};
    return bad_key(faults.front().key, faults.front().what, faults.front().allowed);
}

}  // namespace nullscope
