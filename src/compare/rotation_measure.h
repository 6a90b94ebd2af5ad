// Faraday rotation between frequencies: the electric vector's angle is chi_0 + RM lambda^2 behind a screen. Above 0 the field points to the observer,
// and the angle grows, counterclockwise in the picture, with the wavelength (RM = 2.63e-13 rad/m^2 times the integral of n B dl of cold electrons,
// cm^-3, G and cm). Angles are known to half turns: an RM is one of all that differ by a multiple of pi/(difference of lambda^2), the smallest.
#pragma once
#include <string>
#include <vector>

#include "image/band_picture.h"
#include "image/image.h"

namespace nullscope {

struct RotationMeasure {
    double low_GHz, high_GHz;  // the two frequencies
    double rad_m2;
    double step_rad_m2;  // what it may be more or less, by any whole number
};
// Between each band and the next, of the sums of Q and U over the picture. Empty for less than two bands, or where one has no linear polarisation.
std::vector<RotationMeasure> rotation_measures(const std::vector<BandPicture>& bands);

// Of each pixel, rad/m^2, one channel: the slope of the straight line through all bands' angles against lambda^2 (least squares), each angle within a
// quarter turn of that of the next shorter wavelength. 0 where a band has no linear polarisation. Empty as above.
Image<float> rotation_measure_image(const std::vector<BandPicture>& bands);

std::string words_of(const RotationMeasure& rm);  // "RM 230-345 GHz -4.1e+05 rad/m^2 (+ n 3.3e+06)"

}  // namespace nullscope
