// Where the balls that move are, by the light that arrives now: their middles at equal steps of how long ago that light left.
#pragma once
#include <map>

#include "base/result.h"
#include "scene/scene.h"
#include "spacetime/spacetime.h"
#include "table/strip.h"

namespace nullscope {

inline constexpr int kBallPathCells = 1023;

struct BallPath {
    double from = 0, step = 1;   // of the first node, and from one to the next, r_s/c before the scene's time
    double reach = 0;            // from the centre, of its farthest point, r_s
    double speed = 0;            // its largest, in coordinates
    double least_radius = 1e30;  // as far from the centre as no point of it comes closer
    double height = 0;           // from the plane theta = pi/2 as no point of it goes farther
};

struct BallPaths {
    TexelGrid
        rows;  // two a ball: places, r_s, and the largest acceleration ahead, c^2/r_s; and their derivative, per cell.
               // Cubics between them: (omega h)^4/384 of the path
    std::map<std::size_t, BallPath> balls;  // those that move, by their index in Scene::bodies
};

// For all light that can have come from them, up to some ten half turns about the hole. Errors: those of observer/ball_motion.h.
Result<BallPaths> ball_paths(const Spacetime& spacetime, const Scene& scene);

}  // namespace nullscope
