// Radiance RGBE (.hdr) in memory; used by image_file.cpp.
#pragma once
#include <string_view>

#include "base/image.h"
#include "base/result.h"

namespace nullscope {

bool is_hdr(std::string_view bytes);

// bytes: a whole file. Linear RGB. Errors (without a file name): cut off, damaged, another orientation or colour
// format, larger than max_pixels.
Result<Image<float>> decode_hdr(std::string_view bytes, long long max_pixels);

}  // namespace nullscope
