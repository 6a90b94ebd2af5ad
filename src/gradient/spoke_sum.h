// The integral over a picture as one over directions from a place in it, of what its spokes have: adaptive sectors, and the rule for places along a spoke.
#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "base/result.h"
#include "gradient/camera_view.h"

namespace nullscope {

struct FluxGradient {
    double flux = 0;         // luminance of linear light, summed over the picture, px
    std::vector<double> by;  // by each key of the light
    double flux_error = 0;   // by a rule of half as many spokes, or by sectors twice as wide, where that is more
    std::vector<double> by_error;
    double error =
        0;  // the largest of these, over the flux, the derivative, or 0.01 of the flux a unit where that is more
    long rays = 0;
};

// Gauss and Legendre's, on [0, 1].
struct LegendreRule {
    std::vector<double> at, weight;
    explicit LegendreRule(int n);
};

// Adds the integral of luminance rho drho in this direction (rad from the picture's right, downward), its derivatives and its rays.
using SpokeSum = std::function<void(double angle, FluxGradient& sum)>;
struct SpokedPicture {
    double width, height;  // px
    std::array<double, 2> from;
};
// The camera's, from the image of the direction to the centre. Errors: that is not in it.
Result<SpokedPicture> picture_about_hole(const CameraSpec& camera, const CameraView& view);

// From its beginning along a unit vector to the picture's edge, px.
double to_edge(const SpokedPicture& picture, double x, double y);
// falls_in(rho): whether light there comes from the hole, as all does nearer. Where that ends; 2 end: not before the end.
template <class FallsIn>
double critical_distance(const FallsIn& falls_in, double end) {
    constexpr int kHalvings = 48;
    double low = 0, high = end;
    if (falls_in(high)) return 2 * end;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        (falls_in(middle) ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

// tolerance: of flux and derivatives (or of 0.01 of the flux a unit), for those errors: sectors are halved until then. done(error): after each round. All
// cores.
FluxGradient sum_of_spokes(const SpokedPicture& picture, std::size_t keys, double tolerance, const SpokeSum& spoke,
                           const std::function<void(double)>& done);

}  // namespace nullscope
