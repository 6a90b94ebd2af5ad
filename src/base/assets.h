// Where the files that ship are: $NULLSCOPE_ASSETS, else what ship_assets() says, else beside the executable (../share/nullscope, share/nullscope), else the
// source tree.
#pragma once
#include <filesystem>

namespace nullscope {

std::filesystem::path assets_directory();
// Of a library, whose executable is another's; before anything is loaded.
void ship_assets(const std::filesystem::path& directory);

}  // namespace nullscope
