// The light of a scene's matter along a ray with its derivatives by the seeds of flow.h: optical depth and light are two more numbers of the ray's own
// equations, so that each step carries their derivatives too.
#pragma once
#include "gradient/matter_glow.h"

namespace nullscope {

struct MatterLight {
    Number light, depth;  // 1: the brightness temperature kMediumLight_K; of the whole ray
};

struct MatterRule {
    double ray = 1e-9, light = 1e-6;  // of a step, of the ray and of light and depth
    double faint = 0;                 // light that is off by as much as the tolerance of this may be
};

// from: of an observer without angular momentum outside the horizon. shift: MatterGlow's. Some 5 milliseconds.
MatterLight matter_along(const Flow& flow, const MatterGlow& glow, const Launch& from, const Number& shift,
                         const MatterRule& rule);

}  // namespace nullscope
