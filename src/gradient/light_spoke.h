// The disc's light along a spoke of its picture, as places of a quadrature that move with a scene's numbers. Of each of its images the spoke is cut where the
// light's law changes (DiscGlow::marks), and places move with these cuts: a quadrature without edges, of which each term is differentiated. By the transport
// theorem (O. Reynolds, 1903) that is the derivatives' integral and the edges' motion. Between two cuts places stay on their circles of the disc, so that how the
// emissivity changes along the radius, to which tables give steps, hardly counts.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "gradient/picture_light.h"
#include "gradient/spoke_sum.h"

namespace nullscope {

struct LightSpoke {
    // Of one image, between two cuts. Spokes that have the same pieces change into each other without a jump.
    struct Piece {
        int image, low, high;  // names of what is at its ends
        int places;            // of Gauss and Legendre
        friend bool operator==(const Piece&, const Piece&) = default;
    };
    std::vector<Piece> plan;
    // Of each place of each piece: its distance, px; luminance rho drho there, px^2, the rule's weight included; by each key that light; by each key how far
    // the place moves, px.
    std::vector<double> numbers;
    long rays = 0;
};
constexpr std::size_t place_numbers(std::size_t keys) { return 2 + 2 * keys; }

struct SpokeRule {
    int places;  // in each piece, of Gauss and Legendre; in those of the last image, and where the disc is dim, half
};

// Some 110 rays. from: a place of the picture, px; angle: rad from its right, downward; end: px from there, within the picture or beyond it.
LightSpoke light_spoke(const PictureLight& light, const std::array<double, 2>& from, double angle, double end,
                       const SpokeRule& rule);

}  // namespace nullscope
