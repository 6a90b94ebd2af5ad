// The display transform of shaders/effect/display.glsl on the host, for pictures that the reference tracer drew.
#pragma once
#include "image/image.h"
#include "scene/scene.h"

namespace nullscope {

// RGB linear light to 8-bit display values: bloom, exposure 2^ev (times what the mean luminance asks for, if automatic), tone curve,
// sRGB. Without dithering. Some 100 ms a megapixel with bloom.
Image<unsigned char> display_encoded(const Image<float>& linear, double exposure_ev, const PictureSpec& picture);
// The same in 16 bits.
Image<unsigned short> display_encoded16(const Image<float>& linear, double exposure_ev, const PictureSpec& picture);

// What bloom makes of it: 1 - share of the light where it is, the rest spread as shaders/stage/bloom_*.frag do.
Image<float> with_bloom(const Image<float>& linear, double share);

}  // namespace nullscope
