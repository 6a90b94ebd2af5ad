// Isoradials: where a camera sees the rings of the equatorial plane (Luminet 1979, Astron. Astrophys. 75, 228).
#pragma once
#include <array>
#include <vector>

#include "base/result.h"
#include "reference/frame_tracer.h"

namespace nullscope::reference {

// Image number k (1: met first, 2: after half a turn more ...) of the ring of radius r as a closed curve of pixel positions (column, row),
// one at each of `points` equal angles round the hole's direction; positions behind the camera are left out. In each half plane through
// the radial direction the radius of crossing k grows with the ray's angle from the inward radial: the ring is found by bracketing.
// Empty where that image does not exist. Errors: as FrameTracer::make. About 30 microseconds a point.
Result<std::vector<std::array<double, 2>>> isoradial(const Scene& scene, double r, int k, int points);

}  // namespace nullscope::reference
