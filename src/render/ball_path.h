// Where a ball that moves is, by the light that arrives now: its middle at equal steps of how long ago that light left.
#pragma once
#include "base/result.h"
#include "scene/scene.h"
#include "spacetime/spacetime.h"
#include "table/strip.h"

namespace nullscope {

inline constexpr int kBallPathCells = 1023;

struct BallPath {
    TexelGrid
        row;  // two rows: places, r_s; and their derivative, per cell. Cubics between them: (omega h)^4/384 of the way
    double from = 0, step = 1;  // of the first node, and from one to the next, r_s/c before the scene's time
    double reach = 0;           // from the centre, of its farthest point, r_s
    double speed = 0;           // its largest, in coordinates
    double ground = 1e30;       // as far from the centre as no point of it comes closer
};

// For all light that can have come from it, up to some ten half turns about the hole. Errors: those of scene/ball_motion.h.
Result<BallPath> ball_path(const Spacetime& spacetime, const Scene& scene);

}  // namespace nullscope
