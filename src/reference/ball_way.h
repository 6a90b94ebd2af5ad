// Where the ball of a scene is at a time t, found another way than scene/ball_motion.h: orbits by Kepler's law from differences of the metric.
#pragma once
#include <functional>

#include "reference/orbit.h"
#include "scene/scene.h"

namespace nullscope::reference {

// metric: outlives what is returned. Of a ball in free fall it knows nothing yet.
std::function<Vec3(double t)> ball_way(const OrbitMetric& metric, const BallSpec& ball);

// Omega of a circular geodesic at r: g_tt' + g_phiphi' Omega^2 = 0.
double kepler_rate(const OrbitMetric& metric, double r);

}  // namespace nullscope::reference
