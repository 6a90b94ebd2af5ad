// Draws stars into the faces of a cube map.
//
// A star is a radiance on the sphere, not a pattern of texels: flux 10^(-0.4 V) times a point spread that depends on
// the angle to the star only. So it is as bright at a face's corner as in its middle, and crosses edges without a seam.
#pragma once
#include <vector>

#include "base/vec.h"
#include "sky/sky.h"
#include "sky/star_catalogue.h"

namespace nullscope {

// Peak radiance of a star of V = 5 drawn with the core of a face of kReferenceFace texels: sRGB 0.66 on the display at
// exposure 0, so V < 4 saturates and V = 9 is near the limit of what is seen. It scales the whole star field.
constexpr double kPeakOfMagnitude5 = 0.4;
constexpr int kReferenceFace = 2048;

// Radius of the core in rad: 0.6 texels in the middle of a face, so that a star looks much the same wherever it lies
// between texel centres. Above kReferenceFace it stays what it is there (2 arc minutes, an eye's), so that the picture
// does not depend on the size of the face.
double core_sigma(int face_size);

// Flux of a star of that magnitude V: radiance times solid angle, sr.
double star_flux(double magnitude);

// Adds the stars' radiance, each turned by world_from_sky and multiplied by brightness. The sum over texels, each with
// its solid angle, is a star's flux exactly. Parallel; the result does not depend on the number of threads. Cost:
// about 0.25 s for the whole catalogue at face size 2048 on two cores.
void add_stars(SkyCube& sky, const std::vector<Star>& stars, const Mat3& world_from_sky, double brightness);

}  // namespace nullscope
