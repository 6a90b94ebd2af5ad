// A part of a ray that may be looked along, as curves are made of them (ray_curve.h).
#pragma once
#include <functional>
#include <limits>

namespace nullscope::reference {

inline constexpr double kNowhere = std::numeric_limits<double>::infinity();  // along, or r

struct StretchPlace {
    double r, theta, phi;
    double size;         // areal radius: what changes over a part of it is smooth there
    double lapse2 = 1;   // and over a part of this
    double affine_rate;  // by `along`, of a photon of unit energy at infinity
    double turn_rate;    // how fast it goes round the centre, by `along`, rad
    double t = 0;        // the time here is this and the integral of
    double t_rate = 0;   // this by `along`
    double sigma =
        1;  // d(affine) = sigma d(Mino's time): r^2 + a^2 cos^2(theta), without rotation the areal radius squared
};
struct StretchMotion {
    double r, theta, phi, t;  // by the affine parameter, away from the camera
};

struct RayStretch {
    double from, to;  // along
    double longest;   // that a piece of it may be
    std::function<StretchPlace(double along)> at;
    std::function<StretchMotion(double along)> motion;
};
// Is shown one after the other; they stay as they are during the call only.
using StretchWatch = std::function<void(const RayStretch& stretch)>;

}  // namespace nullscope::reference
