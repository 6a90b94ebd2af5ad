#include "telescope/beam.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace nullscope {
namespace {

constexpr double kReach = 4;  // standard deviations

// Weights at -reach, ..., reach px, which add up to 1.
struct Kernel {
    int reach = 0;
    std::vector<double> weights;
    Kernel(double variance, int most) {
        reach = std::min(static_cast<int>(std::ceil(kReach * std::sqrt(variance))), most);
        double sum = 0;
        for (int k = -reach; k <= reach; ++k) {
            weights.push_back(k == 0 ? 1 : std::exp(-0.5 * k * k / variance));
            sum += weights.back();
        }
        for (double& weight : weights) weight /= sum;
    }
    double at(int k) const { return *(weights.begin() + k + reach); }
};

// to[x] += weight from[x + shift], where that is in the row; in pixels.
void add_shifted(float* to, const float* from, int shift, float weight, int width, int channels) {
    const int first = std::max(0, -shift) * channels, last = std::min(width, width - shift) * channels;
    for (int i = first; i < last; ++i) to[i] += weight * from[i + shift * channels];
}

template <class Row>
Image<float> by_rows(const Image<float>& light, const Row& row) {
    Image<float> out(light.width, light.height, light.channels);
    tbb::parallel_for(0, light.height, [&](int y) { row(out.at(0, y), y); });
    return out;
}

}  // namespace

// The Gaussian is one along the rows times one along a slanted line, whose places between pixels are interpolated: what that widens is
// taken off the first.
Image<float> convolved(const Image<float>& light, double pixel, const Beam& beam) {
    const double deviation_px = 1 / (2 * std::sqrt(2 * M_LN2) * pixel);
    const double major = std::pow(deviation_px * beam.major, 2), minor = std::pow(deviation_px * beam.minor, 2);
    const double s = std::sin(beam.angle), c = std::cos(beam.angle);
    const double right = major * s * s + minor * c * c, down = major * c * c + minor * s * s;
    const double slant = down > 0 ? (major - minor) * s * c / down : 0;
    const Kernel columns(down, light.height);
    double widened = 0;
    for (int k = -columns.reach; k <= columns.reach; ++k) {
        const double part = slant * k - std::floor(slant * k);
        widened += columns.at(k) * part * (1 - part);
    }
    const Kernel rows(std::max(right - slant * slant * down - widened, 0.0), light.width);
    const Image<float> along = by_rows(light, [&](float* to, int y) {
        for (int k = -rows.reach; k <= rows.reach; ++k)
            add_shifted(to, light.at(0, y), k, static_cast<float>(rows.at(k)), light.width, light.channels);
    });
    return by_rows(along, [&](float* to, int y) {
        for (int k = std::max(-columns.reach, -y); k <= std::min(columns.reach, light.height - 1 - y); ++k) {
            const double at = slant * k, part = at - std::floor(at);
            const int shift = static_cast<int>(std::floor(at));
            if (std::abs(at) >= light.width) continue;
            const float* from = along.at(0, y + k);
            add_shifted(to, from, shift, static_cast<float>(columns.at(k) * (1 - part)), light.width, light.channels);
            if (part > 0)
                add_shifted(to, from, shift + 1, static_cast<float>(columns.at(k) * part), light.width, light.channels);
        }
    });
}

}  // namespace nullscope
