#include "base/file_part.h"

#include <algorithm>
#include <fstream>

namespace nullscope {

std::string file_part(const std::filesystem::path& file, std::size_t bytes, FileEnd end) {
    std::ifstream in(file, std::ios::binary);
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (end == FileEnd::kLast && !error && size > bytes) in.seekg(static_cast<std::streamoff>(size - bytes));
    std::string part(bytes, '\0');
    in.read(part.data(), static_cast<std::streamsize>(bytes));
    part.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
    return part;
}

}  // namespace nullscope
