#include "scene/spot_orbit.h"

#include <cmath>

#include "spacetime/circular_orbit.h"
#include "spacetime/registry.h"

namespace nullscope {

std::optional<double> spot_period(const Scene& scene) {
    if (scene.spots.empty()) return {};
    const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    const auto orbit = spacetime ? circular_orbit(**spacetime, scene.spots.front().r) : std::nullopt;
    if (!orbit) return {};
    return 2.0 * M_PI / orbit->omega;
}

}  // namespace nullscope
