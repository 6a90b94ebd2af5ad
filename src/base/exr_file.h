// OpenEXR with a limit of size; used by image_file.cpp.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "base/image_file.h"

namespace nullscope {

// load_exr; an error if there are more than max_pixels.
Result<ChannelImage> load_exr_limited(const std::filesystem::path& path, long long max_pixels);

// The same for a file in memory; name: what errors call it.
Result<ChannelImage> decode_exr(std::string_view bytes, const std::string& name, long long max_pixels);

}  // namespace nullscope
