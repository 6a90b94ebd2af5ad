// A rotating hole as the reference knows it. Its rays are integrated (kerr_ray.h); no camera and no matter is at rest by itself.
#pragma once
#include <memory>

#include "reference/metric.h"

namespace nullscope::reference {

// Without spin, Schwarzschild's orbits.
std::unique_ptr<Metric> make_kerr_metric(const SpacetimeSpec& spec);

}  // namespace nullscope::reference
