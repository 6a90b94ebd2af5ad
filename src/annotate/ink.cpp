#include "annotate/ink.h"

#include <algorithm>
#include <cmath>

namespace nullscope {
namespace {

constexpr double kOutline = 0.14;                          // standard deviation of the outline, of an em
constexpr double kOutlineGain = 2.4, kOutlineMost = 0.72;  // its darkness

// Along rows and columns, zero outside.
Sheet blurred(const Sheet& from, double sigma) {
    const int reach = static_cast<int>(std::ceil(3.0 * sigma));
    std::vector<float> weights;
    for (int i = -reach; i <= reach; ++i)
        weights.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma))));
    float sum = 0.0f;
    for (const float weight : weights) sum += weight;
    const auto pass = [&](const Sheet& in, int dx, int dy) {
        Sheet out(in.width, in.height);
        for (int y = 0; y < in.height; ++y)
            for (int x = 0; x < in.width; ++x)
                for (int i = -reach; const float weight : weights) {
                    const int u = x + i * dx, v = y + i * dy;
                    ++i;
                    if (u < 0 || v < 0 || u >= in.width || v >= in.height) continue;
                    out.at(x, y) += weight / sum * in.data[static_cast<std::size_t>(v) * in.width + u];
                }
        return out;
    };
    return pass(pass(from, 1, 0), 0, 1);
}

}  // namespace

Mark outlined(const Sheet& ink, int x, int y, double em, double strength) {
    const double sigma = std::max(kOutline * em, 1.0);
    const int pad = static_cast<int>(std::ceil(3.0 * sigma));
    Sheet wide(ink.width + 2 * pad, ink.height + 2 * pad);
    for (int row = 0; row < ink.height; ++row)
        for (int column = 0; column < ink.width; ++column) wide.at(column + pad, row + pad) = ink.at(column, row);
    const Sheet dark = blurred(wide, sigma);
    Mark mark{x - pad, y - pad, Image<unsigned char>(wide.width, wide.height, 4)};
    for (std::size_t i = 0; i < wide.data.size(); ++i) {
        const double white = strength * wide.data[i], black = std::min(kOutlineGain * dark.data[i], kOutlineMost);
        const double alpha = 1.0 - (1.0 - white) * (1.0 - black);
        const auto grey = static_cast<unsigned char>(std::lround(alpha > 0.0 ? 255.0 * white / alpha : 0.0));
        unsigned char* to = mark.rgba.data.data() + 4 * i;
        to[0] = to[1] = to[2] = grey;
        to[3] = static_cast<unsigned char>(std::lround(255.0 * alpha));
    }
    return mark;
}

}  // namespace nullscope
