// How a file says its picture is to be turned: TIFF's and Exif's numbers 1 (as it is) to 8.
#pragma once
#include <string_view>

#include "image/image.h"

namespace nullscope {

// tiff: what follows "Exif\0\0" of a JPEG, or a PNG's eXIf chunk. 1 where it says nothing, or is damaged.
int exif_orientation(std::string_view tiff);

// 5 to 8 exchange width and height.
Image<float> turned(const Image<float>& image, int orientation);

}  // namespace nullscope
