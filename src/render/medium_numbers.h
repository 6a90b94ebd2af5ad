// Numbers of matter along rays (shaders/medium).
#pragma once
#include "plan/frame_plan.h"
#include "scene/medium_grid.h"
#include "shadercore/frame_data.h"

namespace nullscope {

// grid: of a medium from a file.
void put_medium(FrameData& frame, const FramePlan& plan, const MediumGrid* grid);

}  // namespace nullscope
