#include "reference/orbit.h"

#include <array>

#include "reference/dneg_orbit.h"
#include "reference/ellis_orbit.h"
#include "reference/janis_newman_winicour_orbit.h"
#include "reference/minkowski_orbit.h"
#include "reference/reissner_nordstrom_orbit.h"
#include "reference/schwarzschild_orbit.h"
#include "reference/star_orbit.h"

namespace nullscope::reference {
namespace {

struct Entry {
    const char* key;
    std::unique_ptr<OrbitMetric> (*make)(const SpacetimeSpec& spec);
};
constexpr std::array kMetrics{
    Entry{"schwarzschild", make_schwarzschild_orbits},
    Entry{"reissner-nordstrom", make_reissner_nordstrom_orbits},
    Entry{"neutron-star", make_star_orbits},
    Entry{"ellis", make_ellis_orbits},
    Entry{"dneg-wormhole", make_dneg_orbits},
    Entry{"janis-newman-winicour", make_janis_newman_winicour_orbits},
    Entry{"minkowski", make_minkowski_orbits},
};

}  // namespace

Result<std::unique_ptr<OrbitMetric>> make_orbit_metric(const SpacetimeSpec& spec) {
    std::string known;
    for (const Entry& entry : kMetrics) {
        if (spec.metric == entry.key) return entry.make(spec);
        known += known.empty() ? entry.key : std::string(", ") + entry.key;
    }
    return bad_input("the reference tracer has no orbits for the metric '" + spec.metric + "' (it knows: " + known +
                     ")");
}

}  // namespace nullscope::reference
