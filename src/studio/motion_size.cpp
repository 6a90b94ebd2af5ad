#include "studio/motion_size.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nullscope::viewer {
namespace {

constexpr double kUnknown = 4.0;  // times, of a picture of unknown cost: a sixteenth of its pixels
constexpr double kCoarsest = 8.0;
constexpr double kStep = 1.25;  // of sizes: textures of each are made once
constexpr double kFinerBelow =
    0.7;  // of what the next finer size may take, by the last picture alone: else sizes would alternate
constexpr double kFinerBelowMean = 0.85;  // by the last few
constexpr double kFollow = 0.25;          // how far a mean goes to what is new
constexpr double kFails = 1.25;           // times what a picture may take

}  // namespace

// By the last picture: what it took goes by its pixels, or by its sides.
double MotionSize::proportional(const Costs& costs, double most_ms) const {
    const auto fits = [&](double times, double share) {
        return costs.last_ms * std::pow(times_ / times, costs.matter ? 1 : 2) <= share * most_ms;
    };
    double times = times_;
    while (times > 1.0 && fits(times / kStep, kFinerBelow)) times = std::max(times / kStep, 1.0);
    while (times < kCoarsest && !fits(times, 1.0)) times *= kStep;
    return times;
}

// What it takes by itself, and a wait while the driver draws the window, which is the same for each size.
double MotionSize::beside_window(const Costs& costs) {
    if (std::exchange(alone_ms_, costs.alone_ms) != costs.alone_ms)
        wait_ms_ = -1.0, most_ms_ = costs.alone_ms, whole_fails_ = false;
    // Another view may be cheaper: what the window's size would have taken at most.
    most_ms_ += kFollow * (costs.last_ms * times_ * times_ - most_ms_);
    const double alone_ms = std::min(costs.alone_ms, most_ms_);
    const auto by_itself_ms = [&](double times) { return alone_ms / (times * times); };
    const double wait_ms = std::max(costs.last_ms - by_itself_ms(times_), 0.0);
    wait_ms_ = wait_ms_ < 0.0 ? wait_ms : wait_ms_ + kFollow * (wait_ms - wait_ms_);
    const auto expected_ms = [&](double times) { return wait_ms_ + by_itself_ms(times); };
    whole_fails_ = whole_fails_ || (times_ == 1.0 && expected_ms(1.0) > kFails * kMotion_ms);
    if (alone_ms <= kWholeInMotion_ms && !whole_fails_) return 1.0;
    double times = times_;
    if (times > 1.0 && expected_ms(times / kStep) <= kFinerBelowMean * kMotion_ms)
        times = std::max(times / kStep, 1.0);
    else if (times < kCoarsest && expected_ms(times) > kMotion_ms)
        times *= kStep;
    return times;
}

double MotionSize::next(const Costs& costs) {
    const double most_ms = costs.matter ? kMotionInMatter_ms : kMotion_ms;
    if (costs.last_ms <= 0.0)
        times_ = kUnknown;
    else if (costs.matter || costs.alone_ms <= 0.0)
        times_ = proportional(costs, most_ms);
    else
        times_ = beside_window(costs);
    return times_ = std::clamp(times_, 1.0, kCoarsest);
}

}  // namespace nullscope::viewer
