// What the relative paths of a scene's files are relative to.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace nullscope {

// In this order: a file is that of the first folder in which it is. "": the current folder. Never without an entry.
using SceneFolders = std::vector<std::filesystem::path>;

// A path as a scene file in these folders may name it: without the folder that it begins with; others as they are.
std::string path_in(const SceneFolders& folders, const std::filesystem::path& path);

}  // namespace nullscope
