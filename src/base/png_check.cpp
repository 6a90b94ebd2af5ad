// PNG specification, 5.3: after eight bytes, chunks of length (four bytes, big-endian), type, data and checksum.
#include "base/png_check.h"

#include <cstdint>

namespace nullscope {

Status check_png(std::string_view bytes) {
    constexpr std::size_t kSignature = 8, kHead = 8,
                          kFrame = 12;  // bytes: of the file; before and around a chunk's data
    bytes.remove_prefix(kSignature);
    while (bytes.size() >= kHead) {
        std::uint32_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length = length << 8 | static_cast<unsigned char>(bytes[i]);
        if (length + std::uint64_t{kFrame} > bytes.size()) return bad_input("a chunk is longer than the file");
        if (bytes.substr(4, 4) == "IEND") break;
        bytes.remove_prefix(kFrame + length);
    }
    return Done{};
}

}  // namespace nullscope
