#include "render/display.h"

#include <cmath>

#include "base/image_file.h"

namespace nullscope {

Image<unsigned char> display_encoded(const Image<float>& linear, double exposure_ev) {
    const float exposure = static_cast<float>(std::exp2(exposure_ev));
    Image<unsigned char> out(linear.width, linear.height, 3);
    for (std::size_t i = 0; i < out.data.size(); ++i) {
        const float encoded = srgb_from_linear(1.0f - std::exp(-linear.data[i] * exposure));
        out.data[i] = static_cast<unsigned char>(std::lround(255.0f * encoded));
    }
    return out;
}

}  // namespace nullscope
