#include "compare/image_metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/image_file.h"

namespace nullscope {

Result<ImageMeasures> measure_images(const Image<float>& a, const Image<float>& b, double threshold) {
    if (a.width != b.width || a.height != b.height)
        return bad_input(fmt::format("sizes differ: {}x{} and {}x{}", a.width, a.height, b.width, b.height));
    if (a.channels < 3 || b.channels < 3) return bad_input("a picture needs three channels: R, G, B");
    ImageMeasures m;
    m.difference = Image<float>(a.width, a.height, 1);
    double sum = 0, squares = 0, above = 0;
    for (std::size_t i = 0; i < m.difference.data.size(); ++i) {
        float largest = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const float va = a.data[i * static_cast<std::size_t>(a.channels) + c];
            const float vb = b.data[i * static_cast<std::size_t>(b.channels) + c];
            const float d = va == vb ? 0.0f : std::abs(va - vb);  // equal infinities differ by nothing
            const float counted = std::isnan(d) ? std::numeric_limits<float>::infinity() : d;
            largest = std::max(largest, counted);
            sum += counted;
            squares += static_cast<double>(counted) * counted;
        }
        m.difference.data[i] = largest;
        above += largest > threshold;
    }
    const auto pixels = static_cast<double>(std::max<std::size_t>(m.difference.data.size(), 1));
    static_cast<Spread&>(m) = spread_of(m.difference.data);
    m.mean = sum / (3 * pixels);
    m.psnr_db = -10 * std::log10(squares / (3 * pixels));
    m.fraction_above = above / pixels;
    return m;
}

Image<float> display_values(const Image<float>& linear) {
    Image<float> shown = linear;
    std::transform(shown.data.begin(), shown.data.end(), shown.data.begin(),
                   [](float v) { return std::isfinite(v) ? srgb_from_linear(v) : v; });
    return shown;
}

}  // namespace nullscope
