// What must hold of a PNG file before stb_image may see it; used by image_file.cpp.
#pragma once
#include <string_view>

#include "base/result.h"

namespace nullscope {

// bytes: a whole file that begins like a PNG. Error (without a file name): a chunk that is longer than the file goes on;
// stb_image (2.27) allocates up to 2 GB for one before it reads.
Status check_png(std::string_view bytes);

}  // namespace nullscope
