// The numbers of the uniform block (shaders/shared/frame_block.glsl): what would cancel in float is formed here in double.
#pragma once
#include "render/ball_path.h"
#include "scene/scene.h"
#include "shadercore/frame_data.h"
#include "spacetime/spacetime.h"
#include "table/ray_fan.h"

namespace nullscope {

// What textures tell the uniform block.
struct TextureFacts {
    int sky_size = 0, disc_width = 0;
    bool two_skies = false;  // in one texture, with borders
};

// spacetime: the rays'. matter: what shifts light, if it is another. The scene's observer must exist.
FrameData frame_numbers(const Scene& scene, const Spacetime& spacetime, const RayFan* fan, const TextureFacts& textures,
                        const Spacetime* matter = nullptr, const BallPath* ball_path = nullptr);

}  // namespace nullscope
