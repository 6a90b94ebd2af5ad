#include "telescope/light_points.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nullscope {
namespace {

constexpr std::size_t kSums = 8;  // sums side by side, which compilers vectorise
constexpr std::size_t kBlock =
    64;  // places whose fringes are formed together; each half is filled up to whole blocks by dark ones

struct FringeBlock {
    std::array<double, kBlock> cosine, sine;
};

// Of 2 pi turns: sine and cosine of half of the angle less whole turns, within (-pi/2, pi/2], by their series to 1e-9, and then doubled.
void form_fringes(const double* l, const double* m, Baseline baseline, FringeBlock& fringe) {
    constexpr double kToWhole = 6755399441055744.0;  // 1.5 2^52: added and taken away it leaves whole numbers
    for (std::size_t i = 0; i < kBlock; ++i) {
        const double turns = baseline.u * l[i] + baseline.v * m[i],
                     half = M_PI * (turns - ((turns + kToWhole) - kToWhole)), t = half * half;
        const double s =
            half * (1 + t * (-1.0 / 6 +
                             t * (1.0 / 120 +
                                  t * (-1.0 / 5040 + t * (1.0 / 362880 + t * (-1.0 / 39916800 + t / 6227020800.0))))));
        const double c =
            1 + t * (-1.0 / 2 +
                     t * (1.0 / 24 +
                          t * (-1.0 / 720 +
                               t * (1.0 / 40320 + t * (-1.0 / 3628800 + t * (1.0 / 479001600 - t / 87178291200.0))))));
        fringe.cosine[i] = 1 - 2 * s * s, fringe.sine[i] = 2 * s * c;
    }
}

}  // namespace

void LightPoints::add(double l, double m, const std::array<double, 4>& light, bool odd) {
    if (std::ranges::all_of(light, [](double plane) { return plane == 0.0; })) return;
    Half& half = halves_[odd ? 1 : 0];
    const std::size_t number = half.count++;
    if (number % kBlock == 0) {
        half.l.resize(number + kBlock), half.m.resize(number + kBlock);
        for (std::size_t plane = 0; plane < static_cast<std::size_t>(planes_); ++plane)
            half.light[plane].resize(number + kBlock);
    }
    half.l[number] = l, half.m[number] = m;
    for (std::size_t plane = 0; plane < static_cast<std::size_t>(planes_); ++plane)
        half.light[plane][number] = light[plane];
}

Visibility LightPoints::sum(const Half& half, Baseline baseline) const {
    Visibility found{};
    FringeBlock fringe;
    for (std::size_t from = 0; from < half.l.size(); from += kBlock) {
        form_fringes(half.l.data() + from, half.m.data() + from, baseline, fringe);
        for (std::size_t plane = 0; plane < static_cast<std::size_t>(planes_); ++plane) {
            const double* light = half.light[plane].data() + from;
            std::array<double, kSums> real{}, imaginary{};
            for (std::size_t i = 0; i < kBlock; i += kSums)
                for (std::size_t k = 0; k < kSums; ++k) {
                    real[k] += light[i + k] * fringe.cosine[i + k];
                    imaginary[k] += light[i + k] * fringe.sine[i + k];
                }
            for (std::size_t k = 0; k < kSums; ++k) found[plane] += std::complex<double>(real[k], imaginary[k]);
        }
    }
    return found;
}

VisibilitySum LightPoints::at(Baseline baseline) const {
    const Visibility even = sum(halves_[0], baseline), odd = sum(halves_[1], baseline);
    VisibilitySum found;
    for (std::size_t plane = 0; plane < even.size(); ++plane)
        found.all[plane] = even[plane] + odd[plane], found.change[plane] = even[plane] - odd[plane];
    return found;
}

double LightPoints::whole() const {
    double sum = 0;
    for (const Half& half : halves_) sum = std::accumulate(half.light[0].begin(), half.light[0].end(), sum);
    return sum;
}

void LightPoints::scale(double factor) {
    for (Half& half : halves_)
        for (auto& plane : half.light)
            for (double& light : plane) light *= factor;
}

}  // namespace nullscope
