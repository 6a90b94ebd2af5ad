// The uniform block's numbers of what changes with time, and of how long light takes (shaders/shared/frame_block.glsl, from `delay` on).
#pragma once
#include <array>

#include "render/ball_path.h"

namespace nullscope {

inline constexpr std::size_t kMovingRows = 6;  // delay, disc_winding, spot, spot_look, spot_motion, ball_path

// spacetime: the rays'; matter: what they meet. Phases are reduced in double: floats keep their digits at any time.
std::array<std::array<double, 4>, kMovingRows> moving_numbers(const Scene& scene, const Spacetime& spacetime,
                                                              const Spacetime& matter, const BallPath* ball_path);

}  // namespace nullscope
