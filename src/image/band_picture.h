// One of several frequencies at which a picture of matter is seen (medium.frequency = [86, 230], docs/matter.md).
#pragma once
#include "image/image.h"

namespace nullscope {

struct BandPicture {
    double frequency_GHz;
    Image<float>
        light;  // one channel: brightness temperature in 1e9 K (Rayleigh and Jeans), whatever the matter's colour and brightness
    Image<float>
        stokes;  // I, Q, U, V likewise where light is polarised, angles from the picture's right towards up; else empty
};

}  // namespace nullscope
