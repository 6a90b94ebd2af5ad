// What a step of a ray in dual numbers is off by, over what is allowed: values and derivatives, each over the size of what it belongs to.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "gradient/flow.h"

namespace nullscope {

template <std::size_t N>
class StepError {
public:
    // less_exact: of the same step. Both outlive this.
    StepError(const std::array<Number, N>& end, const std::array<Number, N>& less_exact)
        : end_(end), other_(less_exact) {}

    // `count` numbers from `first` that belong together. least: their size at least. share: of the tolerance, that they may use.
    void add(std::size_t first, std::size_t count, double least, double share = 1) {
        double size = least;
        for (std::size_t i = first; i < first + count; ++i) size = std::max(size, std::fabs(end_[i].value));
        for (std::size_t i = first; i < first + count; ++i) take(end_[i].value - other_[i].value, share * size);
        for (std::size_t seed = 0; seed < kSeeds; ++seed) {
            double slope = size;
            for (std::size_t i = first; i < first + count; ++i) slope = std::max(slope, std::fabs(end_[i].d[seed]));
            for (std::size_t i = first; i < first + count; ++i)
                take(end_[i].d[seed] - other_[i].d[seed], share * slope);
        }
    }
    // What all rays have but the time. energy: the photon's; innermost: u of the horizon.
    void add_ray(double energy, double innermost) {
        constexpr double kNearHorizon = 1e-3;  // of a step next to the horizon, over that of others
        // What the hole drags is as well known as the distance from the horizon.
        add(kU, 1, 0, std::clamp(1 - end_[kU].value / innermost, kNearHorizon, 1.0)), add(kW, 1, energy), add(kN, 3, 0),
            add(kTurn, 3, energy), add(kDragged, 1, 1);
    }
    double over(double tolerance) const { return worst_ / tolerance; }  // not a number where the step left the metric

private:
    void take(double off, double size) {
        const double error = std::fabs(off) / size;
        if (!(error <= worst_)) worst_ = error;  // NaN stays
    }
    const std::array<Number, N>&end_, &other_;
    double worst_ = 0;
};

}  // namespace nullscope
