// How the frequencies of light from a solid body arrive: its shift from where it left the body's surface to infinity.
#pragma once
#include "reference/bodies.h"
#include "reference/metric.h"
#include "reference/traced_ray.h"

namespace nullscope::reference {

// The velocity dx/dt of a body's surface where it is met, flat coordinates, c. Of a ball, that of its middle. Of what else moves, its
// surface's along the normal. By differences: to some 1e-8.
Vec3 body_velocity(const BodyPart& part, Vec3 place, double t);

// Factors on ray.shift (TracedRay). A body at rest has the four-velocity of an observer at rest in its coordinates. A ball that moves shines
// all over as at its middle: with the velocity there, and the photon's energy there, by an observer without angular momentum; the photon's direction is the one
// where it leaves the surface, vectors along flat coordinates' axes. Any other surface that moves has its own velocity. 0 where nothing can move like that: within an
// ergosphere, or faster than light. lensing: LightSpec::lensing. hit: of `ray`, with a body that has a temperature.
Shift body_shift(const Metric& matter, const TracedRay& ray, const BodyHit& hit, bool lensing);

}  // namespace nullscope::reference
