// SHA-256 of files: what a picture says of the files that it was drawn from, and what `sha256sum` prints.
#pragma once
#include <filesystem>
#include <string>

#include "base/result.h"

namespace nullscope {

// 64 hexadecimal digits. Reads the file once, and again when its size or time has changed; thread-safe. Errors: the file cannot be read.
Result<std::string> sha256_of(const std::filesystem::path& file);

}  // namespace nullscope
