// Motion vectors: how far what a pixel sees moves in the picture until the next one.
#pragma once
#include <functional>
#include <vector>

#include "scene/ray.h"

namespace nullscope {

// Of each pixel, top row first.
struct RayMotion {
    std::vector<float> right, up;  // px; 0 where it is not known
    std::vector<float> known;      // 1 or 0
};

// Where what this pixel sees has gone, in the coordinates of ray data, when its light left `time` later than that which the pixel sees, r_s/c.
using MovedPlace = std::function<Vec3(const RayPixel& pixel, double time)>;

// now, next: ray data of one size, `time` apart. Of the sky's directions and of places on the disc and on bodies; the same image of them, by
// Newton's method in `next`, between whose pixels rays are interpolated by cubics: to 0.02 px where images are wider than some ten
// pixels (tests/unit/test_ray_motion.cpp, tests/gpu/test_beside_picture.cpp). Not known: what the next picture does not show, light that is captured, stars, rims.
// Cost: some 3 microseconds a pixel.
RayMotion ray_motion(const RayFrame& now, const RayFrame& next, double time, const MovedPlace& moved);

}  // namespace nullscope
