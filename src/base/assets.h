// Where the files that ship are: $NULLSCOPE_ASSETS, else beside the executable (../share/nullscope), else the source tree.
#pragma once
#include <filesystem>

namespace nullscope {

std::filesystem::path assets_directory();

}  // namespace nullscope
