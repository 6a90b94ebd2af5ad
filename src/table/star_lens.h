// Where the images of a star are: the swept angle of the rays that reach the sky, turned round.
//
// A star at the angle Theta from the outward radial has its image k on the ray that sweeps Phi = k pi + Theta (k even)
// or (k + 1) pi - Theta (k odd, on the other side of the hole). With T = tan(theta/2), theta the angle of that ray from
// the inward radial, the image's solid angle over the star's is (2 T/(1 + T^2))^2 |d ln T/dPhi| / sin(Theta).
//
// Seen from far away all of the bending happens next to Phi = pi, within the Einstein angle: 4.5e-5 rad at 1e9 r_s. So
// the row's cells are those of x = asinh(b/(2 eps)), where
//     b = -cot(Phi/2) before Phi = pi, (Phi - pi)/2 beyond it;  eps = T of the Einstein ring, Phi = pi.
// In the weak field T = E, E = eps exp(-x) = sqrt(b^2/4 + eps^2) - b/2: the lens equation b = eps^2/E - E. What the row
// holds, T/E, is near 1 and smooth at every distance.
#pragma once
#include "table/ray_family.h"
#include "table/strip.h"

namespace nullscope {

inline constexpr int kStarLensCells = 1024, kStarImages = 4;

// kStarLensCells cells of equal x, from Phi = 1e-3 (T/E is constant before that) to kStarImages pi or the last ray that
// reaches the sky; a texel at each end of a cell: T/E, its slope by cells, -d ln T/dx, its slope by cells, for Hermite's
// cubics. After these one texel (eps, x of the first texel, cells per x, 0). Below 1 ms.
TexelGrid star_lens_row(const RayFamily& family);

}  // namespace nullscope
