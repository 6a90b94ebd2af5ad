// Numbers of what a scene has several of, solid bodies and hot spots, and of what bodies, disc and sky are painted with.
#pragma once
#include <vector>

#include "plan/frame_plan.h"
#include "render/ball_paths.h"
#include "shadercore/frame_data.h"
#include "table/ray_family.h"
#include "table/surface_clearance.h"

namespace nullscope {

SolidFormula solid_of(const SurfaceSpec& surface);
// The uniform block of shaders/shared/objects.glsl. family: of the camera, nullptr where rays are no family's.
std::vector<FrameVector> object_numbers(const FramePlan& plan, const RayFamily* family, const BallPaths& paths,
                                        const SurfaceClearances& clearances);
// Radii about the centre between which all bodies lie that are found by steps, and the shortest step.
void put_march(FrameData& frame, const FramePlan& plan, const BallPaths& paths);
void put_patterns(FrameData& frame, const Scene& scene);
// What changes with time of the disc. Phases are reduced in double: floats keep their digits at any time.
void put_moving(FrameData& frame, const FramePlan& plan);

}  // namespace nullscope
