// Places about a closed curve, denser towards it, and the window that divides a picture between them and a plain grid.
//
// A place has the angle a about the curve's middle and the distance d = core sinh(s) along the ray from the middle, outside of the curve above 0. Steps in
// s and a are even, so that d's are in proportion to d: each image of a photon ring, exp(-gamma) as wide as the one before and as much nearer to the curve,
// has as many places. Light is summed by the trapezoid rule, which for smooth light that ends within is as good as any rule: its error falls faster
// than every power of the step. Each angle's places are shifted against those of the next by a fixed share of a step, 2 - golden ratio: what the rule
// is wrong by at one angle, where light is thinner than a step, cancels over the angles unless baselines see that many fringes.
//
// The window is 1 from -kCore[0] to kCore[1] mean radii from the curve, and falls to 0 at -kEnd[0] and kEnd[1], all derivatives
// continuous. A grid sees 1 less the window of the light: no picture needs to say of which order its light is.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace nullscope {

// In any unit; right and up.
struct ClosedCurve {
    std::array<double, 2> middle{};
    std::vector<double> radius{};  // at even angles from right towards up, the first at 0; above 0
};

class RingChart {
public:
    static constexpr std::array<double, 2> kCore = {0.1, 0.25}, kEnd = {0.45, 0.6};

    RingChart(ClosedCurve curve, int across);  // as many angles as the curve has

    int across() const { return across_; }
    int around() const { return static_cast<int>(curve_.radius.size()); }
    double reach() const;  // no place is farther from the origin, right or up
    struct Place {
        std::array<double, 2> at;
        double area;  // that it stands for
        double window;
    };
    Place place(int number, int angle) const;
    double window(double right, double up) const;

private:
    double window_at(double distance) const;
    ClosedCurve curve_;
    int across_;
    double mean_, core_, first_, step_;
};

}  // namespace nullscope
