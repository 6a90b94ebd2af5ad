// Primaries that files name, and the way from theirs to Rec. 709's.
#pragma once
#include <optional>

#include "base/vec.h"

namespace nullscope {

// CIE 1931 x and y.
struct Chromaticity {
    double x = 0, y = 0;
};
struct Primaries {
    Chromaticity red, green, blue, white;
};

// The matrix from linear light of these primaries to linear light of Rec. 709 and D65, white to white (Bradford's adaptation). nullopt: they
// are Rec. 709's, to 0.002, or span no colours.
std::optional<Mat3> rec709_from(const Primaries& primaries);

}  // namespace nullscope
