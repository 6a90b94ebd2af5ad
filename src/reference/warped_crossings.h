// Where a ray in a plane meets a disc whose rings lie in planes of their own.
#pragma once
#include <vector>

#include "reference/plane_ray.h"
#include "scene/disc_shape.h"

namespace nullscope::reference {

// The swept angles, growing, at most `most`: where the place at the ray's radius is in the plane of that radius' ring, the first and the last one's
// beyond all rows. Error 1e-13 rad, but for rays along the disc; two meetings are missed that are closer than a look (0.04 rad, 3 % of r) to each other and
// between whose middle and the disc three looks' parabolas see none. Some 100 places of the orbit and more, a tenth of a millisecond.
std::vector<double> warped_crossings(const PlaneRay& ray, const DiscShape& shape, int most);

}  // namespace nullscope::reference
