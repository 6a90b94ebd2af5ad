// Swept angles where neither a deflection table nor a barrier's quartic is: by quadrature for each ray (spacetime/ray_potential.h).
//
// dphi = density dx/sqrt(P), P = q^2 - V. From a turning point x = e + s^2, from there on in octaves of the distance from the ridge, far out
// in 1/r; Gauss panels that are halved until halving changes nothing.
#pragma once
#include "spacetime/potential_survey.h"

namespace nullscope {

// A ray through a camera outside of the ridge. d = q^2 - V(ridge) without cancellation; slope = q cos(beta), above 0 inward.
struct SweptRay {
    double r, q, d, slope;
};
// Until infinity, of a ray that gets there. Error 2e-10, and of the angle (tests/unit/test_open_formula.cpp). Some hundred to two thousand values of V.
double swept_to_sky(const PotentialSurvey& world, const SweptRay& ray);
// Until the end, of one that does not.
double swept_to_end(const PotentialSurvey& world, const SweptRay& ray);

}  // namespace nullscope
