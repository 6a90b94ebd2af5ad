// One channel of an image, pixel after pixel.
#pragma once
#include <vector>

#include "image/image.h"

namespace nullscope {

inline std::vector<float> channel_of(const Image<float>& image, int channel) {
    std::vector<float> values;
    values.reserve(image.data.size() / static_cast<std::size_t>(image.channels));
    for (std::size_t i = static_cast<std::size_t>(channel); i < image.data.size();
         i += static_cast<std::size_t>(image.channels))
        values.push_back(image.data[i]);
    return values;
}

}  // namespace nullscope
