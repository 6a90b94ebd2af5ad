// One channel of an image of three, pixel after pixel.
#pragma once
#include <vector>

#include "image/image.h"

namespace nullscope {

inline std::vector<float> channel_of(const Image<float>& image, int channel) {
    std::vector<float> values;
    values.reserve(image.data.size() / 3);
    for (std::size_t i = static_cast<std::size_t>(channel); i < image.data.size(); i += 3)
        values.push_back(image.data[i]);
    return values;
}

}  // namespace nullscope
