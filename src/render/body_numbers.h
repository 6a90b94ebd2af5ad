// Solid bodies' part of the uniform block, and what the disc and the sky are painted with.
#pragma once
#include "render/ball_path.h"
#include "scene/scene.h"
#include "shadercore/frame_data.h"
#include "spacetime/spacetime.h"
#include "table/ray_fan.h"

namespace nullscope {

// fan: of the camera, nullptr where rays are no fan's. ball_path: of a ball that moves, else nullptr.
void put_bodies(FrameData& frame, const Scene& scene, const Spacetime& spacetime, const RayFan* fan,
                const BallPath* ball_path);
void put_patterns(FrameData& frame, const Scene& scene);

}  // namespace nullscope
