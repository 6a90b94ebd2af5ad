// Numbers of matter along rays (shaders/medium).
#pragma once
#include "plan/frame_plan.h"
#include "shadercore/frame_data.h"

namespace nullscope {

void put_medium(FrameData& frame, const FramePlan& plan);

}  // namespace nullscope
