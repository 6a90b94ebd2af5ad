// A picture of errors: colour by the logarithm of the value, with a legend bar below.
#pragma once
#include <array>

#include "image/image.h"

namespace nullscope {

struct HeatScale {
    double low = 1e-4, high = 1;  // 0 < low < high: black at and below low, white above high; not finite: magenta
};

inline constexpr HeatScale kPixelHeat{1e-4, 1};  // of errors in px, in files and on the screen

std::array<unsigned char, 3> heat_colour(double value, HeatScale scale);

// values: one channel. The result is RGB, at least kHeatMapWidth wide, the legend (decades, their powers of ten) below.
inline constexpr int kHeatMapWidth = 200, kLegendHeight = 28;
Image<unsigned char> heat_map(const Image<float>& values, HeatScale scale);

}  // namespace nullscope
