// The inverse of a growing function on [low, high]: a table for the first guess, then Newton's steps kept within its bracket.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace nullscope {

class InverseMap {
public:
    InverseMap() = default;
    // f(x) grows from first to last as x goes from 0 to x_end.
    template <class F>
    InverseMap(const F& f, double x_end) : x_end_(x_end) {
        for (std::size_t i = 0; i < kNodes; ++i) at_[i] = f(x_end * static_cast<double>(i) / (kNodes - 1));
    }
    // x with f(x) = y; rate(x) = dx/dy. Some three evaluations of both.
    template <class F, class Rate>
    double operator()(double y, const F& f, const Rate& rate) const {
        if (!(y > at_.front())) return 0.0;
        if (!(y < at_.back())) return x_end_;
        const std::size_t i =
            std::clamp<std::size_t>(std::upper_bound(at_.begin(), at_.end(), y) - at_.begin(), 1, kNodes - 1);
        const double cell = x_end_ / (kNodes - 1);
        double low = cell * static_cast<double>(i - 1), high = cell * static_cast<double>(i);
        double x = low + cell * (y - at_[i - 1]) / (at_[i] - at_[i - 1]);
        for (int step = 0; step < kMostSteps; ++step) {
            const double off = f(x) - y;
            (off > 0.0 ? high : low) = x;
            double next = x - off * rate(x);
            if (!(next >= low && next <= high)) next = 0.5 * (low + high);
            // Newton's step squares what is off: below a hundred millionth one more is the last.
            const bool done = std::fabs(off) <= 1e-9 * y || std::fabs(next - x) <= 1e-16 * std::fabs(x);
            x = next;
            if (done) break;
        }
        return x;
    }

private:
    static constexpr std::size_t kNodes = 2049;
    static constexpr int kMostSteps = 60;  // of halvings, should Newton's steps leave the bracket
    std::array<double, kNodes> at_{};
    double x_end_ = 0.0;
};

}  // namespace nullscope
