// The table by which shaders know a warped disc and its rings (object/disc_shape.glsl).
#pragma once
#include "scene/scene.h"
#include "table/strip.h"

namespace nullscope {

inline constexpr int kDiscWarpCells = 2000;      // DISC_WARP_CELLS; textures of 2048 are everywhere
inline constexpr double kDiscWarpBeside = 0.25;  // DISC_WARP_BESIDE

// One row of kDiscWarpCells + 1 texels at equal steps of ln r, from kDiscWarpBeside below the inner rim to as much above the outer one: unit normal along
// DiscShape::base(), DiscShape::within. No time of the scene's changes it. Error of straight lines between texels, of a normal: 1/8 of its second
// derivative by ln r times the square of their distance; 3e-6 where it turns by 20 degrees from r to 1.3 r, between rims 3 and 20. A millisecond.
TexelGrid disc_warp_row(const DiscSpec& disc);

}  // namespace nullscope
