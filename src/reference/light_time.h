// How long light takes from a place on a ray to the camera, by quadrature of dt = q/(zeta^2 A) dphi along the closed-form orbit; and
// what clock tells it when the camera has none of its own.
#pragma once
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "reference/orbit.h"

namespace nullscope::reference {

// r_* - r, r_* = integral of dr/A with r_* - r - ln(r) -> 0 at infinity. r outside the horizon. Relative error 1e-12.
double tortoise_excess(const OrbitMetric& metric, double r);

struct Passage {
    double time, closest, angle;  // t; r of the turning point; swept
};
// Light from r = `from` past a Schwarzschild mass to r = `to`, impact parameter b. Nothing where it does not come by there. Time by
// radius, not by angle: far out one rounding of the angle is r^2/b of them in the radius. Within 4 roundings of the time.
std::optional<Passage> light_past(const OrbitMetric& metric, double from, double to, double impact);

// Of one ray. What is told is the camera's clock minus t of the place: t at a camera at rest; v - r, v = t + r_*, at one that falls.
class LightClock {
public:
    // q: E r_s/L, infinite for a radial ray. metric, orbit: outlive this.
    LightClock(const OrbitMetric& metric, const Orbit& orbit, double q, double camera_r, bool falls);
    // After a swept angle outside the horizon, 0 <= angle < orbit.angle(); NaN where there is no such light. Absolute error 1e-11 of the
    // light time. Some 20 places of the orbit for each piece of the way that is asked about first, then some 30 ns.
    double delay(double angle);

private:
    static constexpr std::size_t kTerms = 20;
    struct Piece {                // a sum of Chebyshev's polynomials
        double from, to, before;  // time up to `from`
        std::array<double, kTerms + 1> time;
        double at(double angle) const;
    };
    double rate(double angle) const;     // of t
    void go_on();                        // by a piece
    double time_of(double angle) const;  // on a piece
    double time_of_v(double from, double to) const;
    const OrbitMetric& metric_;
    const Orbit& orbit_;
    double q_, r0_, start_ = 0;
    bool by_v_;                       // on or inside the horizon: the regular form
    std::vector<Piece> pieces_;       // one after the other, from 0 on
    std::map<double, double> known_;  // of v
};

}  // namespace nullscope::reference
