// Part of a file, without the rest.
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

namespace nullscope {

// So many bytes of its beginning or its end, fewer where it has no more or cannot be read.
enum class FileEnd { kFirst, kLast };
std::string file_part(const std::filesystem::path& file, std::size_t bytes, FileEnd end);

}  // namespace nullscope
