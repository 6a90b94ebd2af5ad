// Light of a black body as the CIE 1931 standard observer sees it.
//
// I_nu/nu^3 is the same for all observers, so light of a black body of temperature T that arrives with its frequencies
// multiplied by g is that of a black body of temperature gT, brightness included: no other factor belongs to it.
#pragma once
#include "base/vec.h"

namespace nullscope {

// Tristimulus values (X, Y, Z) of Planck's spectral radiance: its sum over the colour-matching functions at every 5 nm from 380
// to 780 nm, in W sr^-1 m^-2 (luminance in cd/m^2 is 683 lm/W times Y). temperature_K > 0. Below some 200 K all are 0. The 5 nm
// steps leave chromaticities within 1e-4 of the integral. About a microsecond.
Vec3 black_body_xyz(double temperature_K);

// The same and its derivative by the temperature, 1/K of it.
struct BlackBodySlope {
    Vec3 xyz, slope;
};
BlackBodySlope black_body_slope(double temperature_K);

// Linear light in the primaries of Rec. 709 with white at D65 (IEC 61966-2-1); components may be negative: colours outside of
// its gamut, such as black bodies below 1 900 K.
Vec3 rec709_from_xyz(Vec3 xyz);

// The nearest colour of the same luminance inside the gamut, on the line to white: for rec709 with negative components.
Vec3 into_gamut(Vec3 rec709);

// log2 of how bright a black body is: its luminance Y, or if bolometric the power at all wavelengths over 1 K's, T^4.
double log2_brightness(double temperature_K, bool bolometric);

}  // namespace nullscope
