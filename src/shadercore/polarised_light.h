// shaders/core/polarisation.glsl in double: the polarisation of light from a place in the equatorial plane.
#pragma once
#include <complex>
#include <optional>

#include "base/vec.h"

namespace nullscope {

// What a photon brings to the plane; of any energy.
struct PolarisedPhoton {
    double energy, momentum;  // L_z, r_s
    double climb;             // p_r Delta/r^2
    double p_theta;
};

// The matter there, in the vectors of that file.
struct PolarisedPlace {
    double r, a, lapse;
    Vec3 u;      // u^t, u^phi, g_rr u^r
    Vec3 field;  // unit, along r, theta and phi
};

// Q + iU over I on a screen that stands so to kappa (observer/screen_form.h). fraction: that is polarised; nothing: by scattering.
std::complex<double> polarised_light(const PolarisedPhoton& photon, const PolarisedPlace& place,
                                     std::optional<double> fraction, std::complex<double> phase);

}  // namespace nullscope
