// The plane of a disc: through the centre, leaning from the equator.
#pragma once
#include <cmath>

#include "base/vec.h"

namespace nullscope {

// The axis leans by `tilt` from z, rad, [0, pi]. node: azimuth where the disc's x turns to y upward through the equatorial plane, rad, at time 0;
// it moves by `precession`, rad per r_s/c, all of the disc together.
struct DiscLean {
    double tilt = 0.0, node = 0.0, precession = 0.0;
    friend bool operator==(const DiscLean&, const DiscLean&) = default;
};

// Right-handed unit vectors in world axes. x and y: the world's, turned about the line of nodes by the tilt.
struct DiscPlane {
    Vec3 x{1, 0, 0}, y{0, 1, 0}, normal{0, 0, 1};
    Vec3 place(double at_x, double at_y) const { return at_x * x + at_y * y; }
};

// At a time of the scene. Without a tilt the world's axes to the last bit.
inline DiscPlane disc_plane(const DiscLean& lean, double time) {
    if (lean.tilt == 0.0) return {};
    const double node = lean.node + lean.precession * time, c = std::cos(node), s = std::sin(node);
    // 1 - cos(tilt) as a square: small tilts keep their digits
    const double half = std::sin(0.5 * lean.tilt), less = 2.0 * half * half, up = std::sin(lean.tilt);
    return {{1.0 - s * s * less, s * c * less, -s * up},
            {s * c * less, 1.0 - c * c * less, c * up},
            {s * up, -c * up, std::cos(lean.tilt)}};
}

// Of a unit vector from the centre, over the plane; 0 exactly where a plane's own roundings hide it.
inline double height_over(const DiscPlane& plane, Vec3 outward) {
    constexpr double kInPlane = 1e-12;
    const double height = dot(plane.normal, outward);
    return std::fabs(height) < kInPlane ? 0.0 : height;
}

}  // namespace nullscope
