// What observers measure of a picture's polarisation (Palumbo, Wong and Prather 2020, ApJ 894, 156).
#pragma once
#include <complex>
#include <string>

#include "image/image.h"

namespace nullscope {

struct StokesMeasures {
    double net;                   // |sum of Q + iU| over the sum of I
    double resolved;              // sum of |Q + iU| over the sum of I
    std::complex<double> beta_2;  // sum of (Q + iU) e^(-2i phi) over the sum of I
    double circular = 0;          // sum of V over the sum of I
};

// stokes: I, Q, U, V, angles from the picture's right towards up; phi likewise, about this place, px from the upper left corner. Without light all are 0.
StokesMeasures stokes_measures(const Image<float>& stokes, double x, double y);

std::string words_of(
    const StokesMeasures&
        measures);  // "polarised 1.2 % net, 43 % resolved, beta_2 0.31 at -122 deg", and where there is any ", circular -0.4 % net"

}  // namespace nullscope
