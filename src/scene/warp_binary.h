// Warp meshes in binary files: SGC and PFM. For warp_file.cpp, whose header tells of them.
#pragma once
#include <string_view>

#include "base/result.h"
#include "scene/warp_file.h"

namespace nullscope {

bool is_warp_binary(std::string_view bytes);
// Errors, without the file's name: cut off, another version, too many nodes, numbers that are not finite or out of range.
Result<WarpNodes> read_warp_binary(std::string_view bytes, const WarpScreen& screen);

}  // namespace nullscope
