// What changes with time, and how long light takes: its part of the uniform block (shaders/shared/frame_block.glsl).
#pragma once
#include "render/ball_path.h"
#include "shadercore/frame_data.h"

namespace nullscope {

// spacetime: the rays'; matter: what they meet. Phases are reduced in double: floats keep their digits at any time.
void put_moving(FrameData& frame, const Scene& scene, const Spacetime& spacetime, const Spacetime& matter,
                const BallPath* ball_path);

}  // namespace nullscope
