// The numbers of the uniform block (shaders/shared/frame_block.glsl): what would cancel in float is formed here in double.
#pragma once
#include <optional>

#include "render/ball_path.h"
#include "scene/frame_plan.h"
#include "shadercore/frame_data.h"
#include "table/ray_fan.h"

namespace nullscope {

// What textures tell the uniform block.
struct TextureFacts {
    int sky_size = 0, disc_width = 0;
    bool two_skies = false;                    // in one texture, with borders
    std::optional<double> disc_temperature_K;  // of the hottest ring; without one the scene's
};

// fan: of the camera's rays, nullptr where they are no family of a radius. ball_path: of a ball that moves, else nullptr.
FrameData frame_numbers(const FramePlan& plan, const RayFan* fan, const TextureFacts& textures,
                        const BallPath* ball_path);

}  // namespace nullscope
