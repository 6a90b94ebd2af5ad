#include "telescope/first_minimum.h"

#include <numbers>

namespace nullscope {
namespace {

Baseline least_between(const std::function<double(Baseline)>& amplitude, Baseline from, Baseline to, int sections) {
    constexpr double kGolden = 1 / std::numbers::phi;
    const auto at = [&](double x) { return Baseline{from.u + x * (to.u - from.u), from.v + x * (to.v - from.v)}; };
    const auto light = [&](double x) { return amplitude(at(x)); };
    double low = 0, high = 1, a = 1 - kGolden, b = kGolden, at_a = light(a), at_b = light(b);
    for (int i = 0; i < sections; ++i) {
        if (at_a < at_b) {
            high = b, b = a, at_b = at_a, a = high - kGolden * (high - low), at_a = light(a);
        } else {
            low = a, a = b, at_a = at_b, b = low + kGolden * (high - low), at_b = light(b);
        }
    }
    return at(0.5 * (low + high));
}

}  // namespace

std::optional<LeastVisibility> first_minimum(const std::function<double(Baseline)>& amplitude,
                                             std::span<const Baseline> line, std::span<const double> amplitudes,
                                             int sections) {
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        if (!(amplitudes[i] < amplitudes[i - 1] && amplitudes[i] <= amplitudes[i + 1])) continue;
        const Baseline least = least_between(amplitude, line[i - 1], line[i + 1], sections);
        return LeastVisibility{least, amplitude(least)};
    }
    return std::nullopt;
}

}  // namespace nullscope
