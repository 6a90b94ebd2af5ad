#include "telescope/ring_chart.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace nullscope {
namespace {

constexpr double kCoreShare =
    2e-4;  // of the mean radius: nearer than this steps are even; of Schwarzschild's images n = 3 is at 1e-4

// From 1 at 0 to 0 at 1, and so beyond; all derivatives are 0 at both.
double fall(double x) {
    if (x <= 0.0) return 1.0;
    if (x >= 1.0) return 0.0;
    return 1.0 / (1.0 + std::exp(1.0 / (1.0 - x) - 1.0 / x));
}

}  // namespace

RingChart::RingChart(ClosedCurve curve, int across) : curve_(std::move(curve)), across_(across) {
    const auto& radius = curve_.radius;
    mean_ = std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(radius.size());
    core_ = kCoreShare * mean_;
    first_ = -std::asinh(kEnd[0] / kCoreShare);
    step_ = (std::asinh(kEnd[1] / kCoreShare) - first_) / across_;
}

double RingChart::reach() const {
    const double farthest = *std::ranges::max_element(curve_.radius) + kEnd[1] * mean_;
    return farthest + std::max(std::fabs(curve_.middle[0]), std::fabs(curve_.middle[1]));
}

RingChart::Place RingChart::place(int number, int angle) const {
    const double turn = 2 * M_PI / around(), shift = angle * (2.0 - std::numbers::phi), a = turn * angle,
                 s = first_ + step_ * (number + shift - std::floor(shift)), distance = core_ * std::sinh(s),
                 from_middle = curve_.radius[static_cast<std::size_t>(angle)] + distance;
    return {{curve_.middle[0] + from_middle * std::cos(a), curve_.middle[1] + from_middle * std::sin(a)},
            from_middle * core_ * std::cosh(s) * step_ * turn,
            window_at(distance)};
}

double RingChart::window(double right, double up) const {
    const double x = right - curve_.middle[0], y = up - curve_.middle[1];
    const double place = std::atan2(y, x) / (2 * M_PI) * around(), below = std::floor(place);
    const auto radius = [&](double angle) {
        const auto number = static_cast<int>(angle) % around();
        return curve_.radius[static_cast<std::size_t>(number < 0 ? number + around() : number)];
    };
    return window_at(std::hypot(x, y) - std::lerp(radius(below), radius(below + 1), place - below));
}

double RingChart::window_at(double distance) const {
    const std::size_t side = distance < 0 ? 0 : 1;
    return fall((std::fabs(distance) / mean_ - kCore[side]) / (kEnd[side] - kCore[side]));
}

}  // namespace nullscope
