#include "plan/caps.h"

#include <fmt/format.h>

#include <cmath>

#include "scene/bodies.h"
#include "spacetime/spacetime.h"

namespace nullscope {
namespace {

// The largest angular velocity that matter can have at r on the equator, in either sense; 0 where nobody says.
double light_rate(const Spacetime& spacetime, double r, double sense) {
    const auto g = spacetime.equator(r);
    if (!g) return 0.0;
    return (std::sqrt(std::fmax(g->across2, 0.0)) - sense * g->g.tphi) / g->g.phiphi;
}

}  // namespace

std::vector<SceneFault> cap_faults(const Spacetime& spacetime, const Scene& scene) {
    std::vector<SceneFault> faults;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const auto* sphere = std::get_if<SphereSpec>(&scene.bodies[i].shape);
        if (sphere == nullptr || sphere->spin_rate == 0.0) continue;
        const std::string key = body_section(scene, i) + ".spin_rate";
        if (sphere->amplitude > 0.0) faults.push_back({key, "a sphere that pulsates does not turn", "amplitude = 0"});
        const double most = light_rate(spacetime, sphere->radius, sphere->spin_rate > 0.0 ? 1.0 : -1.0);
        if (most > 0.0 && !(std::fabs(sphere->spin_rate) < most))
            faults.push_back({key, fmt::format("{} is faster than light on its equator", sphere->spin_rate),
                              fmt::format("below {:.6g}", most)});
    }
    if (scene.caps.empty()) return faults;
    const Body* sphere = seen_sphere(scene);
    if (sphere == nullptr)
        faults.push_back({"cap", "there is no [sphere] that keeps its size", "a [sphere] with a temperature"});
    else if (!sphere->material.temperature_K)
        faults.push_back({"cap", "its sphere has no temperature",
                          "sphere.temperature; with sphere.colour = [0, 0, 0] the caps alone shine"});
    return faults;
}

}  // namespace nullscope
