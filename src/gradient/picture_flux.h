// The flux of a picture's disc and its derivatives. The images of rims and of the critical curve move with a scene's numbers, so that the mean of the pixels'
// derivatives is not that of the flux: it lacks what the edges sweep over. Here it is a sum over spokes from where the hole is (gradient/light_spoke.h).
#pragma once
#include <functional>
#include <vector>

#include "base/result.h"
#include "gradient/picture_light.h"
#include "gradient/spoke_sum.h"

namespace nullscope {

struct FluxRule {
    int places = 12;  // as SpokeRule
    double tolerance =
        1e-3;  // of flux and derivatives (or of 0.01 of the flux a unit), for those errors: sectors are halved until then
};

// done(error): after each round, of halved sectors. All cores. Errors: the hole is not in the picture.
Result<FluxGradient> flux_gradient(const PictureLight& light, const FluxRule& rule = {},
                                   const std::function<void(double)>& done = {});

}  // namespace nullscope
