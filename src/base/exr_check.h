// What must hold of an OpenEXR file's headers before OpenEXR may see them; used by exr_file.cpp.
#pragma once
#include <string_view>

#include "base/result.h"

namespace nullscope {

// bytes: a whole file. OpenEXR (3.1) allocates whatever size an attribute announces, up to 2 GB, before it looks whether
// the file goes on for so long. Errors (without a file name): not an OpenEXR file, cut off, an attribute whose size is
// not that of its type or of what is in it.
Status check_exr(std::string_view bytes);

}  // namespace nullscope
