// A photon's place and momentum as those of a straight line and what it is off it. Far away the impact parameter is
// what matters, and there the place is up to 1e9 times as long: here it is a number of its own, with the rounding of
// its own size, and so is the bending so far.
//
//     place = foot + begin n + lambda speed n + delta,     momentum = speed n + deviation,
//     d delta/dlambda = deviation + drift,                 d deviation/dlambda = force      (kerr_chart.h)
//
// n: a unit vector, foot: the line's point nearest to the hole. A rounding of n turns the line about its foot: nothing
// comes of it.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "reference/kerr_chart.h"

namespace nullscope::reference {

// What is integrated, in lambda from the line's own begin: delta; unit times the deviation; kClockUnit times t less
// energy lambda.
using KerrState = std::array<double, 7>;
constexpr double kClockUnit = 1e-4;  // its steps are good to 1e-10 r_s/c, and do not ask for shorter ones

struct KerrPhase {  // place and momentum
    Vec3 x, p;
};

struct KerrLine {
    Vec3 foot, n;
    long double begin = 0;  // of lambda = 0, along n from the foot
    double speed = 1;
    double unit = 1;  // some distance from the hole: a deviation weighs by how far it is carried; a power of 2

    static KerrLine of(const KerrPhase& s) { return along(s.p, cross(s.x, s.p), s.x); }
    // momentum: cross(place, p), known without the rounding of the place.
    static KerrLine along(const Vec3& p, const Vec3& momentum, const Vec3& place) {
        const long double px = p.x, py = p.y, pz = p.z, speed = std::sqrt(px * px + py * py + pz * pz);
        KerrLine line;
        line.speed = static_cast<double>(speed);
        line.n = p / line.speed;
        line.foot = cross(p, momentum) / (line.speed * line.speed);
        line.begin = (px * place.x + py * place.y + pz * place.z) / speed;
        return line;
    }
    KerrPhase at(const KerrState& s, double lambda) const {
        const double way = static_cast<double>(begin) + speed * lambda, back = 1 / unit;
        return {foot + way * n + Vec3{s[0], s[1], s[2]}, speed * n + back * Vec3{s[3], s[4], s[5]}};
    }
    void slope(const KerrChart& chart, double energy, const KerrState& s, KerrState& d, double lambda) const {
        const KerrPhase here = at(s, lambda);
        const KerrChart::Pull pull = chart.pull(energy, here.x, here.p);
        const double back = 1 / unit;
        d[0] = back * s[3] + pull.drift.x, d[1] = back * s[4] + pull.drift.y, d[2] = back * s[5] + pull.drift.z;
        d[3] = unit * pull.force.x, d[4] = unit * pull.force.y, d[5] = unit * pull.force.z;
        d[6] = kClockUnit * pull.delay;
    }
    // The deviation in another unit.
    void weigh(double distance, KerrState& s) {
        const double next = std::exp2(std::floor(std::log2(std::max(1.0, distance))));
        for (std::size_t i = 3; i < 6; ++i) s[i] *= next / unit;
        unit = next;
    }
};

}  // namespace nullscope::reference
