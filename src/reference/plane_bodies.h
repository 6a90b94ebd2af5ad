// Where a ray in a plane enters a body: the swept angle, found by looking along its orbit. A few hundred positions, some 50
// microseconds.
#pragma once
#include <functional>
#include <optional>

#include "reference/plane_ray.h"

namespace nullscope::reference {

// time_at: the body's time for what is seen after a swept angle; asked in nearly growing order.
std::optional<double> entry(const PlaneRay& ray, const BodyPart& part, const std::function<double(double)>& time_at);
// In a wormhole, where orbits give l, of either sign, and a body stands on one side.
std::optional<double> entry_by_length(const PlaneRay& ray, const BodyPart& part, double time);

}  // namespace nullscope::reference
