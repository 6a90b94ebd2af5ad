// How the ball of a scene moves: its middle by the time t of the clocks at infinity.
#pragma once
#include <functional>

#include "base/result.h"
#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope {

struct BallPlace {
    Vec3 place, velocity;   // r_s, c; world axes, (r, theta, phi) taken as flat spherical coordinates
};
using BallMotionAt = std::function<BallPlace(double t)>;

// spacetime outlives what is returned. Errors: motion that no ball can have: an orbit at or inside the photon sphere, a fall that begins
// inside the horizon or in a metric whose r is not areal, a formula that is none. A fall is followed from t = 0 to the times asked for, which best move away from it: 1e-8 of
// its radius after some turns, a microsecond for a time of r/100. What reaches the horizon stays next to it.
Result<BallMotionAt> ball_motion(const Spacetime& spacetime, const BallSpec& ball);

}  // namespace nullscope
