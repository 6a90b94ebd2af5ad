// Pictures as textures hold them: half floats, with all mip levels.
#pragma once
#include <cstdint>
#include <vector>

#include "image/image.h"

namespace nullscope {

struct HalfLevel {
    int width = 0, height = 0;
    std::vector<std::uint16_t>
        rgba;  // rounded; alpha below 1 stays below it: what is not opaque is not taken for opaque
};

// The image, of 3 or 4 channels, and its levels down to one pixel, each side half of the one before (rounded down, at least 1): each pixel
// is the mean of the area it covers in the level before, in float, colours weighted by alpha. Of sides of any length: a driver's own filter
// loses light where one is odd.
std::vector<HalfLevel> half_levels(Image<float> image);

}  // namespace nullscope
