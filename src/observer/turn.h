// Turns of a camera's axes: unit quaternions, and the shortest turn from one set of axes to another.
#pragma once
#include "base/vec.h"

namespace nullscope {

struct Quaternion {
    double w = 1, x = 0, y = 0, z = 0;  // of length 1
};

// The axes that x, y, z become.
Mat3 axes_of(Quaternion turn);
// Its inverse, up to the sign. Of right-handed orthonormal axes.
Quaternion turn_of(const Mat3& axes);
// The way from one to the other about one axis, by the share t of the angle: the shorter way, of half a turn either (Shoemake 1985).
Mat3 axes_between(const Mat3& from, const Mat3& to, double t);

}  // namespace nullscope
