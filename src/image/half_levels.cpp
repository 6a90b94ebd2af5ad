#include "image/half_levels.h"

#include <algorithm>
#include <cstddef>

#include "image/area_filter.h"
#include "image/half_float.h"

namespace nullscope {
namespace {

HalfLevel in_halves(const Image<float>& image) {
    constexpr std::uint32_t kOne = 0x3c00;
    HalfLevel level{image.width, image.height, {}};
    const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    level.rgba.reserve(4 * pixels);
    const float* from = image.data.data();
    for (std::size_t i = 0; i < pixels; ++i, from += image.channels) {
        for (int c = 0; c < 3; ++c) level.rgba.push_back(static_cast<std::uint16_t>(half_bits(from[c])));
        const bool opaque = image.channels == 3 || from[3] >= 1.0f;
        level.rgba.push_back(static_cast<std::uint16_t>(opaque ? kOne : std::min(half_bits(from[3]), kOne - 1)));
    }
    return level;
}

}  // namespace

std::vector<HalfLevel> half_levels(Image<float> image) {
    std::vector<HalfLevel> levels = {in_halves(image)};
    while (image.width > 1 || image.height > 1) {
        AreaFilter filter(image.width, image.height, image.channels, std::max(image.width / 2, 1),
                          std::max(image.height / 2, 1));
        for (int y = 0; y < image.height; ++y) filter.add_row(image.at(0, y));
        image = filter.take();
        levels.push_back(in_halves(image));
    }
    return levels;
}

}  // namespace nullscope
