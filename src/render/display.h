// The display transform of shaders/effect/display.glsl on the host, for pictures that the reference tracer drew.
#pragma once
#include "base/image.h"

namespace nullscope {

// RGB linear light to 8-bit display values: exposure 2^ev, shoulder 1 - exp(-x), sRGB.
Image<unsigned char> display_encoded(const Image<float>& linear, double exposure_ev);

}  // namespace nullscope
