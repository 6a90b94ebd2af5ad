// OpenEXR files.
#include "fuzz.h"
#include "image/image_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace nullscope;
    constexpr long long kMaxPixels = 1 << 16;  // small, so that an input costs milliseconds
    const auto image = decode_exr(fuzz::text_of(data, size), "picture.exr", kMaxPixels);
    if (!image) {
        fuzz::must_be_a_good_error(image.error());
        return 0;
    }
    const long long pixels = static_cast<long long>(image->width) * image->height;
    fuzz::must(image->width > 0 && image->height > 0 && pixels <= kMaxPixels, "a size within the limit");
    for (const auto& [name, values] : image->channels)
        fuzz::must(static_cast<long long>(values.size()) == pixels, "every channel is whole");
    return 0;
}
