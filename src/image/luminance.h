// Luminance of linear Rec. 709 light (Recommendation ITU-R BT.709).
#pragma once

namespace nullscope {

inline float luminance_of(const float* rgb) { return 0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2]; }

}  // namespace nullscope
