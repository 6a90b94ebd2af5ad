// The line profile of a thin disc: a line that is sharp where it is emitted, broadened by the Doppler shift and the gravitational redshift
// of matter on circular geodesics (inside the innermost stable one: falling, circular_orbit.h). The broad iron line of Fabian, Rees, Stella and
// White (Mon. Not. R. Astron. Soc. 238, 729 (1989)) and Laor (Astrophys. J. 376, 90 (1991)).
//
// An observer at infinity sees of a disc that emits the intensity emissivity(r) limb(mu) delta(nu - nu_0) in its matter's frame, with
// g = nu/nu_0 and since I/nu^3 is the same for everybody,
//     an energy flux of g^4 and a photon flux of g^3, times emissivity limb d(alpha) d(beta), at g
// (alpha, beta: distant_light.h). Only direct light is counted: what crosses the disc's plane once. With u the matter's velocity, and
// zeta' and Delta the photon's slope and g_tphi^2 - g_tt g_phiphi where it starts,
//     1/g = u^t - lambda u^phi - zeta' r^2 u^r/Delta,   mu = g sqrt(eta)/r.
//
// The integral over the image is a sum over cells of ln(r - r_horizon) and chi (disc_image.h). Within a cell g is linear, so its light is
// distributed over g as the sum of two uniform numbers, a trapezoid, whose part in each bin is exact. Means of g and of light over a cell
// have errors of fourth order. A ring alone has a profile that is infinite at both of its edges, as one over a root; its part in a bin is
// finite, and found along the ring in the same way.
#pragma once
#include <complex>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "spacetime/circular_orbit.h"
#include "spectrum/disc_image.h"

namespace nullscope {

enum class Limb { kIsotropic, kLaor, kHaardt };  // 1; 1 + 2.06 mu (Laor 1991); ln(1 + 1/mu) (Haardt 1993)

// A photon that the observer sees, of energy 1 there: where in the picture, its constants, and zeta' where it leaves the disc.
struct LinePhoton {
    double alpha, beta, lambda, eta, slope;
};
using LinePolarisation = std::function<std::complex<double>(const LinePhoton&)>;  // Q + iU over I

struct DiscLine {
    double inner, outer;  // r_s, outside of the horizon; equal: one ring, of unit width
    // Of each of these radii, in any unit.
    std::function<std::vector<double>(const std::vector<double>& radii)> emissivity;
    std::vector<double> kinks{};  // radii where its slope jumps, ascending; cells end there
    Limb limb = Limb::kIsotropic;
    Sense sense = Sense::kEastward;                            // of its matter
    std::function<LinePolarisation(double r)> polarisation{};  // of light from this radius; nothing: it has none
};

// Cells (rows times columns) and nodes of the image of each part of the disc, within and beyond the innermost stable orbit. A level has twice
// as many of all four as the one before. Level 0 takes some 0.01 core-seconds, 1 0.05, 2 0.2, 3 1.5; of a metric by formulas ten times that.
struct LineCells {
    explicit LineCells(int level)
        : radii(12 << level), angles(48 << level), rows(256 << level), columns(480 << level) {}
    int radii, angles, rows, columns;
};

struct LineProfile {
    double least_g = 0, most_g = 0;          // of all of the disc, for one ring to 1e-9
    double from = 0, to = 0;                 // g: of the bins, which are equal
    std::vector<double> photons, energy;     // in each bin, emissivity times r_s^2 (of a ring: r_s)
    double all_photons = 0, all_energy = 0;  // in the bins or not
    // Q + iU of the photons, angles from alpha towards beta; no bins where light is not polarised. Of the energy flux they are the same fraction.
    std::vector<std::complex<double>> linear;
    std::complex<double> all_linear;
    // Of all photons, the share that is in a bin; and the g at which it begins.
    double share(std::size_t bin) const { return photons[bin] / all_photons; }
    double edge(std::size_t bin) const {
        return from + (to - from) * static_cast<double>(bin) / static_cast<double>(photons.size());
    }
};

// From g = from to g = to; nothing: from the least g to the largest, rounded outward to hundredths. None is filled unless to is above from.
struct LineBins {
    int count = 1000;
    std::optional<double> from, to;
};
LineProfile line_profile(const DistantLight& light, const DiscLine& line, const LineBins& bins, const LineCells& cells);

// How much two profiles differ over the same bins: the largest difference of the photons' shares in a bin, over the largest share.
double profile_change(const LineProfile& a, const LineProfile& b);

// As many cells as it takes.
struct ConvergedProfile {
    LineProfile profile;
    double change;  // to the profile with half of its resolution (profile_change)
};
inline constexpr double kConverged = 5e-3;  // of the largest bin: then no more cells are taken
inline constexpr int kFinest = 3;           // level: what it is off by then is some quarter of `change`
ConvergedProfile converged_profile(const DistantLight& light, const DiscLine& line, const LineBins& bins);

}  // namespace nullscope
