// OpenEXR with a limit of size; used by image_file.cpp.
#pragma once
#include <filesystem>

#include "base/image_file.h"

namespace nullscope {

// load_exr; an error if there are more than max_pixels.
Result<ChannelImage> load_exr_limited(const std::filesystem::path& path, long long max_pixels);

}  // namespace nullscope
