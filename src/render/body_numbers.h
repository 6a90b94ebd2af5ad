// Numbers of what a scene has several of, solid bodies and hot spots, and of what bodies, disc and sky are painted with.
#pragma once
#include <array>
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
// Of A = (1 - x zeta)(1 - y zeta), by which matter goes round with w^2 = A'/(2 r) = zeta^3 ((x + y)/2 - x y zeta);
// about a rotating hole A = 1 - zeta + charge2 zeta^2 takes its place. In flat space matter rests.
std::array<double, 2> circular_rate_numbers(const Spacetime& matter);
// The scene's time, less the camera's r where light takes time: from this the shader takes the delays of places (FrameData::delay). From afar
// floats have no digits left for the difference of the two. r_s/c.
double late_time(const FramePlan& plan);
// What changes with time of the disc. Phases are reduced in double: floats keep their digits at any time.
void put_moving(FrameData& frame, const FramePlan& plan);

}  // namespace nullscope
