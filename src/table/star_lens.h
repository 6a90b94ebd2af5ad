// Where the images of a star are: the swept angle of the rays that reach the sky, turned round.
//
// A star at the angle Theta from the outward radial has its image k on the ray that sweeps Phi = k pi + Theta (k even) or
// (k + 1) pi - Theta (k odd, on the other side of the hole). The angle alpha of that ray from the radial direction grows with Phi;
// the image's solid angle over the star's is |sin(alpha) dalpha / (sin(Theta) dTheta)|.
#pragma once
#include "table/ray_fan.h"
#include "table/strip.h"

namespace nullscope {

inline constexpr int kStarLensCells = 1024, kStarImages = 4;

// kStarLensCells cells of equal Phi from 0 to kStarImages pi, a texel at each end of a cell: (alpha, dalpha/dPhi, 0, 0), for
// Hermite's cubic: alpha within 1e-8 rad, its slope within 1e-6 of itself. About 1 ms.
TexelGrid star_lens_row(const RayFan& fan);

}  // namespace nullscope
