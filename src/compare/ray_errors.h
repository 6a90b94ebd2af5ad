// Errors of one pixel's ray data, in radians and in pixels.
//
// Screen error: by how many pixels would the camera ray have to move for the answer to be exact? The exact answer's motion
// per pixel is a 2x2 matrix J (sky direction or place on the disc, by pixel x and y). The error is split along J's two
// principal directions, and each part divided by how far the exact answer moves per pixel that way, at least what one pixel
// spans without lensing. That is the forward error over the motion per pixel, at least 1, and no less strict where the sky is
// stretched one way only (at the photon ring).
#pragma once
#include <cstddef>
#include <vector>

#include "scene/ray.h"

namespace nullscope {

// The exact answer at a pixel, and beside it: at (x + right_px, y) and (x, y + down_px), px. A displacement of 0 says that
// nothing is known of that side: the answer counts as unmoved.
struct ExactPixel {
    RayPixel here, right, down;
    double right_px = 0, down_px = 0;
    double pixel_angle = 0;  // rad that the pixel spans in the camera's frame: the least motion
    Vec3 camera;             // its place, r_s, world axes: a pixel spans pixel_angle times the distance on the disc
};

// kForgiven: differs within the band around the exact edge.
enum class RayEnd : unsigned char { kNotCompared, kSame, kForgiven, kDiffers };

// Infinite where the tested value is not finite; 0 where there is nothing to compare.
struct PixelErrors {
    float forward_rad = 0;  // angle between the sky directions
    float sky_px = 0;       // the same as screen error
    float place_px = 0;     // of the first hit
    float angle_px = 0;     // of the swept angle
    float g_px = 0;         // of log g
    RayEnd end = RayEnd::kNotCompared;
    bool escaped = false, hit = false;  // what there was to compare

    float worst_px() const;  // infinite for kDiffers, 0 for kForgiven and kNotCompared
    // Of where the pixel's light comes from, sky or disc: the larger of sky_px and place_px. Infinite and 0 as worst_px.
    float screen_px() const;
};

// Same fate and same object?
bool same_end(const RayPixel& a, const RayPixel& b);
bool all_finite(const RayPixel& pixel);

// end: kSame or kDiffers.
PixelErrors pixel_errors(const RayPixel& tested, const ExactPixel& exact);

struct Spread {
    double max = 0, p999 = 0, median = 0;
    std::size_t count = 0;
};
// NaN counts as infinite. The 99.9th percentile and the median are values of the set (rank rounded up).
Spread spread_of(std::vector<float> values);

}  // namespace nullscope
