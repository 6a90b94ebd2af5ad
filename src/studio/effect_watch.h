// What effects cost in the picture on the screen, and when that is measured: once for every set of effects, when the picture rests.
#pragma once
#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "plan/effects.h"

namespace nullscope::viewer {

// The picture's time, less that of the scene without the effect.
struct EffectTimes {
    std::map<Effect, double> effects;  // ms
    double picture_ms = 0.0;           // of the whole
    bool complete = false;
};

class EffectWatch {
public:
    static constexpr double kRest_s = 0.5;  // without a change before they are measured
    const EffectTimes& times() const { return times_; }
    void take(EffectTimes times) { times_ = std::move(times); }
    // The times are of another picture. now: s of a steady clock, here and below.
    void begin(double now) { *this = EffectWatch(), changed_at_ = now; }
    // True once, when it is time to measure.
    bool asks(double now) {
        if (asked_ || now - changed_at_ < kRest_s) return false;
        return asked_ = true;
    }
    // Until it asks; infinite: it has asked.
    double wait(double now) const {
        constexpr double kLeast = 0.01;
        return asked_ ? std::numeric_limits<double>::infinity() : std::max(changed_at_ + kRest_s - now, kLeast);
    }

private:
    EffectTimes times_;
    double changed_at_ = 0.0;
    bool asked_ = false;
};

}  // namespace nullscope::viewer
