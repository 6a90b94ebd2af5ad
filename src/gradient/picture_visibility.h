// What an interferometer measures of a picture's disc, and its derivatives. Long baselines see the thin images next to the critical curve, which pixels do
// not hold: here it is a sum over spokes from where the hole is (gradient/light_spoke.h), evenly all around, and as many more between as fringes ask for, of the
// trigonometric polynomials through their numbers.
#pragma once
#include <complex>
#include <span>
#include <vector>

#include "base/result.h"
#include "gradient/picture_light.h"

namespace nullscope {

// Phases are right (x - width/2) + down (y - height/2) of the place (x, y) px of a picture.
struct Fringes {
    double right, down;  // rad per px
};

struct VisibilityGradient {
    using Sums = std::vector<std::complex<double>>;
    Sums value;            // of luminance e^(i phase) over the picture, px^2, for each pattern of fringes
    std::vector<Sums> by;  // by each key of the light, phases of a place of the picture kept
    Sums by_scale;         // by ln of all fringes' wave numbers
    double flux = 0;       // value without fringes
    std::vector<double> flux_by;
    double error = 0;  // over root mean squares, of half as many spokes: that of all of them is its square or less
    long rays = 0;
};

struct VisibilityRule {
    int places = 12;         // as SpokeRule
    double tolerance = 0.2;  // for that error: spokes are doubled until then, from 8 to 64
};

// All cores; some 2500 rays of 0.2 ms, and 0.1 ms a pattern. Errors: the hole is not in the picture, nor the disc whole; images that are no rings about the
// hole, as next to the disc's plane or inside of it; fringes too dense for that.
Result<VisibilityGradient> visibility_gradient(const PictureLight& light, std::span<const Fringes> fringes,
                                               const VisibilityRule& rule = {});

}  // namespace nullscope
