// Matter of a file at a place, for the reference (scene/medium_grid.h): between nodes by weights of the eight about it.
#pragma once
#include "reference/emission.h"
#include "scene/medium_grid.h"

namespace nullscope::reference {

// At a part of the time from one dump to the next, which has the same nodes.
struct GridMoment {
    const MediumGrid &before, &after;
    double part = 0;
};

// scale: of densities. horizon: the outer one's radius, r_s; 0: none. phi: Boyer and Lindquist's azimuth.
MatterState grid_matter(const GridMoment& moment, double scale, double horizon, double r, double theta, double phi);
inline MatterState grid_matter(const MediumGrid& grid, double scale, double horizon, double r, double theta,
                               double phi) {
    return grid_matter(GridMoment{grid, grid}, scale, horizon, r, theta, phi);
}

}  // namespace nullscope::reference
