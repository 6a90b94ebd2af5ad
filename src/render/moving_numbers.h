// What changes with time: its part of the uniform block (shaders/shared/frame_block.glsl).
#pragma once
#include "render/ball_path.h"
#include "scene/frame_plan.h"
#include "shadercore/frame_data.h"

namespace nullscope {

// ball_path: of a ball that moves, else nullptr. Phases are reduced in double: floats keep their digits at any time.
void put_moving(FrameData& frame, const FramePlan& plan, const BallPath* ball_path);

}  // namespace nullscope
