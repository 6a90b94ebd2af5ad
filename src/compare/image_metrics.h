// Measures between two pictures of one size.
#pragma once
#include "base/result.h"
#include "compare/ray_errors.h"
#include "image/image.h"

namespace nullscope {

// Over all pixels and the three colours; alpha is ignored. A difference with a NaN counts as infinite.
struct ImageMeasures : Spread {  // of a pixel's largest absolute difference
    double mean = 0;             // of the absolute difference
    double psnr_db = 0;          // with 1 as the peak; infinite for equal pictures
    double fraction_above = 0;   // of pixels whose largest absolute difference is above the threshold
    Image<float> difference;     // one channel: a pixel's largest absolute difference
};

// Errors: sizes differ, fewer than three channels.
Result<ImageMeasures> measure_images(const Image<float>& a, const Image<float>& b, double threshold);

// Linear light as a display shows it: [0, 1], sRGB.
Image<float> display_values(const Image<float>& linear);

}  // namespace nullscope
