// OpenEXR files.
#include "fuzz.h"
#include "image/image_file.h"
#include "image/image_formats.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace nullscope;
    constexpr long long kMaxPixels = 1 << 16;  // small, so that an input costs milliseconds
    for (const bool with_alpha : {false, true}) {
        const auto picture = decode_exr_picture(fuzz::text_of(data, size), "picture.exr", kMaxPixels, with_alpha);
        if (!picture) {
            fuzz::must_be_a_good_error(picture.error());
            continue;
        }
        const Image<float>& image = picture->image;
        fuzz::must(static_cast<long long>(image.width) * image.height <= kMaxPixels,
                   "the display window is within the limit");
        fuzz::must(image.channels == 3 || (image.channels == 4 && with_alpha), "three channels, or alpha as well");
    }
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
