// The flux of a picture's disc and its derivatives. The images of rims and of the critical curve move with a scene's numbers, so that the mean of the pixels'
// derivatives is not that of the flux: it lacks what the edges sweep over. Here the picture is cut into spokes from where the hole is, a spoke at the
// images of all radii where the light's law changes (DiscGlow::marks), and its places move with these: a quadrature without edges, of which each term is
// differentiated. By the transport theorem (O. Reynolds, 1903) that is the derivatives' integral and the edges' motion.
#pragma once
#include <functional>
#include <vector>

#include "base/result.h"
#include "gradient/picture_light.h"
#include "gradient/spoke_sum.h"

namespace nullscope {

struct FluxRule {
    int places = 8;  // in each piece of a spoke, of Gauss and Legendre
    double tolerance =
        1e-3;  // of flux and derivatives (or of 0.01 of the flux a unit), for those errors: sectors are halved until then
};

// done(error): after each round, of halved sectors. All cores. Errors: the hole is not in the picture.
Result<FluxGradient> flux_gradient(const PictureLight& light, const FluxRule& rule = {},
                                   const std::function<void(double)>& done = {});

}  // namespace nullscope
