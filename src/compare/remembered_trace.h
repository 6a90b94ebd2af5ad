// Exact rays that are asked for more than once.
#pragma once
#include "compare/ray_metrics.h"

namespace nullscope {

// Each ray is traced once however often it is asked for: for several frames of one camera. Not for several threads. Memory: some 200 bytes a
// ray.
ExactTrace remembered(ExactTrace trace);

// The same where all of a frame's pixels are measured again and again: the rays that measure_rays asks for, through the pixels' middles and
// displaced to the right and downward, are kept by pixel and not looked up. Memory: some 180 bytes a pixel.
ExactTrace remembered(ExactTrace trace, int width, int height);

}  // namespace nullscope
