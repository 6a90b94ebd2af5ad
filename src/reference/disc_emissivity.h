// What a disc shines by that is not accretion. A lamp's light is found by rays that are traced from it, and by the disc's area in the frame of who has no
// angular momentum; no formula of rays on the axis is used.
#pragma once
#include <vector>

#include "reference/disc_light.h"

namespace nullscope::reference {

// At these radii (r_s, ascending, outside the horizon), in any unit. of.velocity(): the matter's. A lamp: some 500 rays, 0.3 seconds about rotating holes.
std::vector<double> emissivity_of(const Metric& metric, const DiscLight& of, const EmissivitySpec& spec,
                                  const std::vector<double>& radii);

// The largest value where powers meet or a table has a row, between these radii; 0 where there is none.
double largest_at_kinks(const EmissivitySpec& spec, double inner, double outer);

}  // namespace nullscope::reference
