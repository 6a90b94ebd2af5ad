// The numbers of the uniform block (shaders/shared/frame_block.glsl): what would cancel in float is formed here in double.
#pragma once
#include <optional>

#include "plan/frame_plan.h"
#include "render/ball_paths.h"
#include "render/light_path.h"
#include "scene/medium_grid.h"
#include "shadercore/frame_data.h"

namespace nullscope {

// What textures tell the uniform block.
struct TextureFacts {
    int sky_size = 0, disc_width = 0;
    std::optional<double> disc_temperature_K;  // of the hottest ring; without one the scene's
    const MediumGrid* grid = nullptr;          // of a medium that has one
    double sky_light = 1.0;                    // of a texel of 1
};

FrameData frame_numbers(const FramePlan& plan, const LightPath& path, const TextureFacts& textures,
                        const BallPaths& balls);

// Where a pixel has samples x samples rays: of a picture of as many pixels as there are rays, of which each fragment draws those that
// put_samples() says.
FrameData sample_numbers(const FramePlan& plan, const LightPath& path, const TextureFacts& textures,
                         const BallPaths& balls, int samples);
// Which of a pixel's rays are drawn, of 0 to samples^2 - 1. With one ray it is that through the pixel's middle. fetches: of the sky along the
// longer side of a pixel's footprint, at most; they are shared out among the rays.
void put_samples(FrameData& frame, int samples, int first, int count, int fetches);

// cos(theta), exactly 0 in the equatorial plane.
double plane_height(double theta);
// Components that are nothing but rounding of the others become 0.
Vec3 direction_without_rounding(Vec3 v);

}  // namespace nullscope
