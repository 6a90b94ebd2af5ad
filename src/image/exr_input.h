// OpenEXR files as they come: what is checked before the package sees them. For the other exr_ files.
#pragma once
#include <ImfForward.h>
#include <ImfIO.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.h"
#include "image/image.h"

namespace nullscope {

inline constexpr std::size_t kMaxExrBytes = std::size_t{8} << 30;

// What must hold of the headers before OpenEXR may see them. OpenEXR (3.1) allocates whatever size an attribute
// announces, up to 2 GB, before it looks whether the file goes on for so long. Errors (without a file name): not an
// OpenEXR file, cut off, an attribute whose size is not that of its type or of what is in it.
Status check_exr(std::string_view file);

// The same of a part's size, before buffers for so many of its channels are made.
Status check_exr_part(const Imf::Header& header, long long channels, std::size_t file_bytes, long long max_pixels);

// A file in memory, as OpenEXR wants it.
class MemoryStream final : public Imf::IStream {
public:
    MemoryStream(std::string_view bytes, const std::string& name) : IStream(name.c_str()), bytes_(bytes) {}
    bool read(char* to, int count) override;
    std::uint64_t tellg() override { return at_; }
    void seekg(std::uint64_t at) override;

private:
    std::string_view bytes_;
    std::uint64_t at_ = 0;
};

}  // namespace nullscope
