// How the interstellar medium blurs a source: an ellipse whose widths grow with the square of the wavelength.
#pragma once
#include <cmath>

#include "telescope/visibility.h"

namespace nullscope {

struct ScatteringKernel {
    double major_mas, minor_mas;  // full widths at half maximum at a wavelength of 1 cm
    double angle;                 // of the longer axis, rad from north through east
};

// Sgr A*: Johnson et al. 2018 (ApJ 865, 104): 1.380 and 0.703 mas at 81.9 degrees. Their Gaussian, measured at centimetres; at 1.3 mm their
// full model differs from it, and adds substructure, which is left out.
inline constexpr ScatteringKernel kSgrAScattering{1.380, 0.703, 81.9 * M_PI / 180};

// What it multiplies a visibility by: exp(-(pi^2/(4 ln 2)) (major^2 along^2 + minor^2 across^2)), in (0, 1].
inline double scattering(const ScatteringKernel& kernel, Baseline baseline, double frequency_hz) {
    constexpr double kMas = M_PI / 180 / 3600e3, kLight_cm_s = 2.99792458e10;
    const double wave = kLight_cm_s / frequency_hz, unit = kMas * wave * wave;
    const double along = baseline.u * std::sin(kernel.angle) + baseline.v * std::cos(kernel.angle),
                 across = baseline.u * std::cos(kernel.angle) - baseline.v * std::sin(kernel.angle);
    const double major = kernel.major_mas * unit * along, minor = kernel.minor_mas * unit * across;
    return std::exp(-M_PI * M_PI / (4 * M_LN2) * (major * major + minor * minor));
}

}  // namespace nullscope
