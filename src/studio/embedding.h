// The equatorial plane of a static spherical metric at one moment, as a surface of revolution in flat space: with B = g_rr and the areal
// radius R, its height is dz/dr = sqrt(B - R'^2). For a hole without charge it is Flamm's paraboloid z = 2 sqrt(r - 1) (Flamm 1916; Misner,
// Thorne and Wheeler 1973, section 23.8). Pure: no window, no OpenGL.
#pragma once
#include <optional>
#include <vector>

#include "spacetime/spherical_metric.h"

namespace nullscope::viewer {

struct EmbeddedCircle {
    double r, areal, z;  // the metric's own radius; of the circle in flat space, r_s
};

// From the inside outward to the areal radius `high`, or to the end of the space where cameras rest: from the horizon, from a star's surface,
// from the far side of a wormhole (z = 0 in its throat), or from where B < R'^2 ends, inside of which there is no such surface (z = 0 there).
// Fewer than two where there is none. Cost: some hundred evaluations of the metric.
std::vector<EmbeddedCircle> embedding(const SphericalMetric& metric, double high);
// z of a radius between the first and the last; nothing beyond them.
std::optional<double> height_at(const std::vector<EmbeddedCircle>& surface, double r);

}  // namespace nullscope::viewer
