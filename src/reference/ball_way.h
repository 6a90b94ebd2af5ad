// Where the ball of a scene is at a time t, found another way than scene/ball_motion.h: orbits by Kepler's law from differences of the metric,
// free fall by Hamilton's equations in t, with the momentum of the tortoise radius, H = sqrt(P^2 + A (1 + L^2/r^2)):
//     dr/dt = A P/H,  dP/dt = -A (A (1 + L^2/r^2))'/(2 H),  dphi/dt = A L/(r^2 H):  nothing grows at the horizon, and no step is refused.
#pragma once
#include <functional>

#include "reference/metric.h"
#include "scene/scene.h"

namespace nullscope::reference {

// Free fall: of metrics whose rays stay in a plane (check_bodies). metric: outlives what is returned, which any number of threads may ask. Free fall: 1e-10 of its radius a turn.
std::function<Vec3(double t)> ball_way(const Metric& metric, const BallSpec& ball);

}  // namespace nullscope::reference
