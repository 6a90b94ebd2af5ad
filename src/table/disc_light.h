// Two small tables for the light of matter in the disc: how it moves and how hot it is by radius (disc_flow_row), and what a
// black body looks like by temperature (black_body_row).
//
// Flux of a thin disc that radiates what it gains (Novikov and Thorne 1973; Page and Thorne 1974, eq. 11b), per unit of
// accretion rate, zero at the innermost stable orbit and inside:
//     F(r) = -Omega' / (4 pi r (E - Omega L)^2)  integral from r_isco to r of (E - Omega L) L' dr.
#pragma once
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "spacetime/circular_orbit.h"
#include "spacetime/spacetime.h"
#include "table/strip.h"

namespace nullscope {

// F at each radius (r_s, any order, outside the photon sphere), in accretion rates per r_s^2 (times 1/4 per M^2). Relative error
// below 1e-9. Flat space: 0.
std::vector<double> disc_flux(const Spacetime& spacetime, const std::vector<double>& radii,
                              Sense sense = Sense::kEastward);

struct FluxPeak {
    double r, flux;
};
// Where the flux is largest, r to 1e-8 of itself. Errors: none; flux 0 in flat space.
FluxPeak disc_flux_peak(const Spacetime& spacetime, Sense sense = Sense::kEastward);

// Temperature (K) of a face that radiates this flux about a hole that takes in `rate_eddington` times L_Eddington/(0.1 c^2).
double disc_temperature_K(double flux, double mass_suns, double rate_eddington);

// Cells of equal ln r between inner and outer, a texel at each end of a cell: (log2 of the temperature over the hottest ring's, u^t,
// u^phi, g_rr u^r). Linear interpolation then leaves at most 2e-6 of the velocity. Where nothing shines the first is -64.
// parts: of g = g_gravity g_doppler, which observers at rest at the matter and at the camera split (docs/light.md). Without Doppler the
// matter is as at rest, (1/sqrt(A), 0, 0); without gravity all three are times sqrt(A), the camera's own part being the frame's. straight: of rays of flat space,
// whose momentum L at r is that of a direction L/r in the frame of matter at rest: u^phi over sqrt(A).
// The second row, by the same cells: the factor by which such parts change a momentum over a frequency of the first row; both disc_lapses(); the
// first row's velocities times this are those of the matter.
inline constexpr int kDiscFlowCells = 1024, kDiscFlowRows = 2;
struct ShiftParts {
    bool doppler = true, gravity = true, straight = false;
};
// leaning: of a disc about a rotating hole with this tilt; the velocity is then 1, leaning_rate(), 0 (spacetime/leaning_circle.h), the heat that of
// the disc of this sense that does not lean. shines: what heats the disc, by these radii, over its largest value; nothing: accretion.
using RingLight = std::function<std::vector<double>(const std::vector<double>& radii)>;
TexelGrid disc_flow_row(const Spacetime& spacetime, double inner, double outer, ShiftParts parts = {},
                        Sense sense = Sense::kEastward, std::optional<double> leaning = {},
                        const RingLight& shines = {});

// For shaders/core/polarisation.glsl: sqrt(Delta)/r at the matter, without rotation sqrt(A), and of the light that it emits: 1 where that runs straight.
std::array<double, 2> disc_lapses(const Spacetime& spacetime, double r, ShiftParts parts);

// A texel's velocity of the first row: u^t, u^phi, g_rr u^r, by these parts. flow: of the spacetime.
Vec3 disc_velocity(const Spacetime& spacetime, const DiscMatterFlow& flow, double r, ShiftParts parts);

// Cells of equal log2 T from 2^kColdest to 2^kHottest K: (r, g, b of Rec. 709 of unit luminance, negative outside of its gamut, log2
// of the luminance). Linear interpolation leaves 1e-5 of the colour and of the luminance's logarithm; below the range it is dark, above
// it colour stays and luminance grows as T.
inline constexpr int kBlackBodyCells = 1024;
inline constexpr double kColdest = 9.0, kHottest = 19.0;
TexelGrid black_body_row();

}  // namespace nullscope
