// How the ball of a scene moves: its middle by the time t of the clocks at infinity.
#pragma once
#include <functional>

#include "base/result.h"
#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope {

struct BallPlace {
    Vec3 place, velocity;  // r_s, c; world axes, (r, theta, phi) taken as flat spherical coordinates
};
using BallMotionAt = std::function<BallPlace(double t)>;

// spacetime outlives what is returned. Errors: motion that no ball can have: an orbit at or inside the photon sphere, a fall that begins
// inside the horizon or in a metric whose r is not areal, a formula that is none. A fall is followed from t = 0 to the times asked for,
// which best move away from it, to 1e-9 r_s (tests/unit/test_ball_motion.cpp). What reaches a horizon or a star stays 1e-6 of it short.
Result<BallMotionAt> ball_motion(const Spacetime& spacetime, const BallSpec& ball);

}  // namespace nullscope
