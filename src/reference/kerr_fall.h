// Free fall of a ball about a rotating hole, found another way than observer/spin_fall.h.
#pragma once
#include <functional>

#include "reference/metric.h"

namespace nullscope::reference {

// Where a ball is at a time t, r_s, flat coordinates; at t = 0 at `position` (outside the ergosphere) with `velocity` along (e_r, e_theta, e_phi) of
// one at rest there. By Hamilton's equations in Cartesian Kerr-Schild coordinates, which separate nothing and are regular on the horizon, to 1e-9 r_s;
// before t = 0 by those of the mirrored way: t and phi both change their sign. metric: of a rotating hole. Any number of threads may ask.
std::function<Vec3(double t)> kerr_fall(const Metric& metric, Vec3 position, Vec3 velocity);

}  // namespace nullscope::reference
