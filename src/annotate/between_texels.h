// An image's values between the middles of its texels, bilinear, clamped at the rim.
#pragma once
#include <algorithm>
#include <array>

#include "image/image.h"

namespace nullscope {

// At (u, v), in texels from the image's top left corner.
class BetweenTexels {
public:
    BetweenTexels(const Image<float>& image, double u, double v) {
        const double x = std::clamp(u - 0.5, 0.0, image.width - 1.0), y = std::clamp(v - 0.5, 0.0, image.height - 1.0);
        const int left = static_cast<int>(x), top = static_cast<int>(y);
        const int right = std::min(left + 1, image.width - 1), bottom = std::min(top + 1, image.height - 1);
        at_ = {image.at(left, top), image.at(right, top), image.at(left, bottom), image.at(right, bottom)};
        const double a = x - left, b = y - top;
        share_ = {(1 - a) * (1 - b), a * (1 - b), (1 - a) * b, a * b};
    }
    double channel(int c) const {
        return share_[0] * at_[0][c] + share_[1] * at_[1][c] + share_[2] * at_[2][c] + share_[3] * at_[3][c];
    }

private:
    std::array<const float*, 4> at_;
    std::array<double, 4> share_;
};

}  // namespace nullscope
