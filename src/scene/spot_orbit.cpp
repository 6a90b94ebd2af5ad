#include "scene/spot_orbit.h"

#include <cmath>

#include "scene/orbit_sense.h"
#include "spacetime/registry.h"

namespace nullscope {

std::optional<double> spot_period(const Scene& scene) {
    if (scene.spots.empty()) return {};
    const SpotSpec& spot = scene.spots.front();
    const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    const auto orbit =
        spacetime ? circular_orbit(**spacetime, spot.r, sense_about(**spacetime, spot.sense)) : std::nullopt;
    if (!orbit) return {};
    return 2.0 * M_PI / std::fabs(orbit->omega);
}

}  // namespace nullscope
