// Every kind of image file but EXR.
#include <algorithm>

#include "fuzz.h"
#include "image/image_file.h"
#include "image/large_image.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace nullscope;
    constexpr long long kMaxPixels = 1 << 20;  // small, so that an input costs milliseconds
    {                                          // by rows, however small
        const auto fitted = decode_fitted_image(fuzz::text_of(data, size), "picture",
                                                {.max_side = 64, .whole_pixels = 0, .max_pixels = kMaxPixels});
        if (!fitted)
            fuzz::must_be_a_good_error(fitted.error());
        else
            fuzz::must(fitted->image.width > 0 && fitted->image.height > 0 &&
                           std::max(fitted->image.width, fitted->image.height) <= 64,
                       "fits");
    }
    const auto image = decode_image(fuzz::text_of(data, size), "picture", kMaxPixels);
    if (!image) {
        fuzz::must_be_a_good_error(image.error());
        return 0;
    }
    fuzz::must(image->channels == 3 || image->channels == 4, "three or four channels");
    fuzz::must(image->width > 0 && image->height > 0, "a size");
    fuzz::must(static_cast<long long>(image->width) * image->height <= kMaxPixels, "the limit of pixels holds");
    fuzz::must(image->data.size() == static_cast<std::size_t>(image->width) * image->height * image->channels, "whole");
    return 0;
}
