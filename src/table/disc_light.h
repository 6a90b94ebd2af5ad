// Two small tables for the light of matter in the disc: how it moves and how hot it is by radius (disc_flow_row), and what a
// black body looks like by temperature (black_body_row).
//
// Flux of a thin disc that radiates what it gains (Novikov and Thorne 1973; Page and Thorne 1974, eq. 11b), per unit of
// accretion rate, zero at the innermost stable orbit and inside:
//     F(r) = -Omega' / (4 pi r (E - Omega L)^2)  integral from r_isco to r of (E - Omega L) L' dr.
#pragma once
#include <vector>

#include "spacetime/spacetime.h"
#include "table/strip.h"

namespace nullscope {

// F at each radius (r_s, any order, outside the photon sphere), in accretion rates per r_s^2 (times 1/4 per M^2). Relative error
// below 1e-9. Flat space: 0.
std::vector<double> disc_flux(const Spacetime& spacetime, const std::vector<double>& radii);

struct FluxPeak {
    double r, flux;
};
// Where the flux is largest, r to 1e-8 of itself. Errors: none; flux 0 in flat space.
FluxPeak disc_flux_peak(const Spacetime& spacetime);

// Cells of equal ln r between inner and outer, a texel at each end of a cell: (log2 of the temperature over the hottest ring's, u^t,
// u^phi, u^r/A). Linear interpolation then leaves at most 2e-6 of the velocity. Where nothing shines the first is -64.
inline constexpr int kDiscFlowCells = 1024;
TexelGrid disc_flow_row(const Spacetime& spacetime, double inner, double outer);

// Cells of equal log2 T from 2^kColdest to 2^kHottest K: (r, g, b of Rec. 709 of unit luminance, negative outside of its gamut, log2
// of the luminance). Linear interpolation leaves 1e-5 of the colour and of the luminance's logarithm; below the range it is dark, above
// it colour stays and luminance grows as T.
inline constexpr int kBlackBodyCells = 1024;
inline constexpr double kColdest = 9.0, kHottest = 19.0;
TexelGrid black_body_row();

}  // namespace nullscope
