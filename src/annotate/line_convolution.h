// Line integral convolution: a texture averaged along the lines of a field of directions, after B. Cabral and L. C. Leedom, Imaging vector fields using
// line integral convolution (SIGGRAPH 1993, pp. 263-270).
#pragma once
#include <vector>

#include "image/image.h"

namespace nullscope {

// Of each pixel of noise (one channel) the mean of noise along the line through it, out to `reach` px either way, with the weights of a Hann window,
// 1 + cos(pi s/reach): a wave of k rad/px along straight lines becomes sin(k reach)/(k reach)/(1 - (k reach/pi)^2) as high, one across them stays. Lines
// run along the electric vector of stokes (I, Q, U, V, angles from right towards up; of any size, for the same view, interpolated). They end at the
// picture's edge and where nothing is polarised, and Q and U that are not finite count as none. lit: of each pixel, whether it is wanted; others are 0.
// Independent of the number of threads. Cost: `reach` interpolations of Q and U and of noise a pixel.
Image<float> line_convolution(const Image<float>& noise, const Image<float>& stokes, double reach,
                              const std::vector<bool>& lit);

}  // namespace nullscope
