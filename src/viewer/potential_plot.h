// The effective potential of light in a static spherical metric, and a ray in it. With the affine parameter that has L = 1,
//     A B (dr/dlambda)^2 = 1/b^2 - V(r),   V = A/R^2:
// a ray is where V is below its level, and turns where it meets V (Misner, Thorne and Wheeler 1973, section 25.6).
#pragma once
#include <optional>
#include <vector>

#include "spacetime/spacetime.h"
#include "viewer/landmark_circles.h"

namespace nullscope::viewer {

inline constexpr const char* kPotentialHelp =
    "Effective potential V = A/R\u00b2 of light, and the level 1/b\u00b2 of the probed ray: it turns where it meets "
    "V.";

// Places are the metric's own r, in wormholes l.
struct PotentialRay {
    double level = 0;            // 1/b^2, 1/r_s^2; infinite for a radial ray
    double camera = 0;           // where it is seen
    std::optional<double> turn;  // of what is traced from there
    std::optional<double> end;   // where it ends; infinite: the sky, or the other sky
    bool straight = false;       // light runs straight: A = 1 in V
};

// V over r, logarithmic where r is a radius, on a square of this side at the cursor of the current window.
void draw_potential(const PotentialRay& ray, const Spacetime& spacetime, const std::vector<LandmarkCircle>& circles,
                    float side);

}  // namespace nullscope::viewer
