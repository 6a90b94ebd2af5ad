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

inline constexpr Primaries kRec709Primaries{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}};
// ACEScg: AP1 and the white of ACES, near D60 (Academy S-2014-004, TB-2018-001).
inline constexpr Primaries kAcesCgPrimaries{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, {0.32168, 0.33767}};

// The matrix from linear light of one to linear light of the other, white to white (Bradford's adaptation). Both span colours.
Mat3 light_matrix(const Primaries& from, const Primaries& to);

// The matrix from linear light of these primaries to linear light of Rec. 709 and D65, white to white (Bradford's adaptation). nullopt: they
// are Rec. 709's, to 0.002, or span no colours.
std::optional<Mat3> rec709_from(const Primaries& primaries);

}  // namespace nullscope
