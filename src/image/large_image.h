// Images of any size, made as small as they must be while they are read: a picture of 29566x14321 px is never held.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"
#include "image/image.h"

namespace nullscope {

struct ImageLimits {
    int max_side = 16384;                  // px, of what is returned
    long long whole_pixels = 32LL << 20;   // of interlaced PNG and progressive JPEG, which are held whole
    long long max_pixels = 2'000'000'000;  // of PNG and JPEG; other files: at most 500'000'000
};

// An image, smaller than its file's if that has a longer side: each pixel the mean of those it stands for, in linear light.
struct FittedImage {
    Image<float> image;
    int width = 0, height = 0;  // the file's
    bool reduced() const { return image.width != width || image.height != height; }
};

// Shows progress. Errors: as load_image; a large PNG that is interlaced, a large JPEG that is progressive. Memory: the image returned and
// a few rows of other PNG and JPEG, else the file and the whole image.
Result<FittedImage> load_fitted_image(const std::filesystem::path& path, const ImageLimits& limits = {});
// The same for a PNG, JPEG or HDR file in memory; name: what errors call it.
Result<FittedImage> decode_fitted_image(std::string_view bytes, const std::string& name,
                                        const ImageLimits& limits = {});

// "'sky.png': 29566x14321 px, read as 8192x3968 px: " + why; empty if nothing was reduced.
std::string reduction_words(const std::filesystem::path& path, const FittedImage& image, const std::string& why);

}  // namespace nullscope
