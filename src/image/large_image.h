// Images of any size, made as small as they must be while they are read: a picture of 29566x14321 px is never held.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "image/image.h"

namespace nullscope {

// What becomes of alpha: a fourth channel that colours are not multiplied by; black behind; no use (colours as they are stored).
enum class Alpha { kKept, kOnBlack, kLeftOut };

struct ImageLimits {
    int max_side = 16384;                  // px, of what is returned
    long long whole_pixels = 32LL << 20;   // of interlaced PNG and progressive JPEG, which are held whole
    long long max_pixels = 2'000'000'000;  // of PNG and JPEG; other files: at most 500'000'000
    Alpha alpha = Alpha::kKept;
    std::string layer{};  // of an EXR with several pictures: its layer or part; empty: the file's own picture
    bool light = true;    // what is no light, below 0 or not finite, is mended: 0, the largest number of the image
};

// An image, smaller than its file's if that has a longer side: each pixel the mean of those it stands for, in linear light. Turned as the file
// says, its primaries those of Rec. 709.
struct FittedImage {
    Image<float> image;
    int width = 0, height = 0;         // the file's, turned
    std::vector<std::string> notes{};  // what of the file is not used, and what was mended: a line each, for people
    bool reduced() const { return image.width != width || image.height != height; }
};

// Shows progress. Errors: as load_image; a large PNG that is interlaced, a large JPEG that is progressive; an EXR with several pictures of
// which none is the file's, or without the layer; a layer of another file. Memory: the image returned and a few rows of other PNG and JPEG, else the file and the whole image.
Result<FittedImage> load_fitted_image(const std::filesystem::path& path, const ImageLimits& limits = {});
// The same for a file in memory that is no EXR; name: what errors call it.
Result<FittedImage> decode_fitted_image(std::string_view bytes, const std::string& name,
                                        const ImageLimits& limits = {});

// The size of an image, by its file's head where that is known to be enough. Errors: as load_fitted_image.
struct ImageSize {
    int width = 0, height = 0;
};
Result<ImageSize> image_size(const std::filesystem::path& path, const std::string& layer = {});

// "'sky.png': 29566x14321 px, read as 8192x3968 px: " + why; empty if nothing was reduced.
std::string reduction_words(const std::filesystem::path& path, const FittedImage& image, const std::string& why);

}  // namespace nullscope
