// A picture on the plane that touches the sky in its middle, the phase centre: what telescopes' baselines measure of it.
#pragma once
#include "image/image.h"

namespace nullscope {

// What stands for the light of a pixel: all of it in its middle; the same brightness everywhere in it; or linear between the middles, which
// is ehtim's own.
enum class PixelShape { kPoint, kSquare, kTriangle };

struct SkyPicture {
    Image<double>
        flux;  // of each pixel, Jy or relative: one channel, or I, Q, U, V. First row: north; first column: east.
    double pixel = 0;  // its side, rad; above 0
};

// Of the plane I.
double total_flux(const SkyPicture& picture);

}  // namespace nullscope
