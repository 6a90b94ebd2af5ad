// Matter of a file at a place, for the reference (scene/medium_grid.h): between nodes by weights of the eight about it.
#pragma once
#include "reference/emission.h"
#include "scene/medium_grid.h"

namespace nullscope::reference {

// scale: of densities. horizon: the outer one's radius, r_s; 0: none. phi: Boyer and Lindquist's azimuth.
MatterState grid_matter(const MediumGrid& grid, double scale, double horizon, double r, double theta, double phi);

}  // namespace nullscope::reference
