#include "image/image_file.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "base/atomic_file.h"
#include "image/image_formats.h"
#include "image/large_image.h"
#include "image/picture_texts.h"

namespace nullscope {
namespace {

ImageLimits as_it_is(long long max_pixels) {
    return {.max_side = std::numeric_limits<int>::max(),
            .whole_pixels = max_pixels,
            .max_pixels = max_pixels,
            .light = false};
}

}  // namespace

Result<Image<float>> decode_image(std::string_view bytes, const std::string& name, long long max_pixels) {
    TRY(fitted, decode_fitted_image(bytes, name, as_it_is(max_pixels)));
    return std::move(fitted->image);
}

Result<Image<float>> load_image(const std::filesystem::path& path, long long max_pixels) {
    TRY(fitted, load_fitted_image(path, as_it_is(max_pixels)));
    return std::move(fitted->image);
}

namespace {

template <class T>
Status save_png_of(const std::filesystem::path& path, const Image<T>& image,
                   const std::map<std::string, std::string>& texts) {
    const long long row = static_cast<long long>(image.width) * image.channels;
    if (image.width <= 0 || image.height <= 0 || (image.channels != 3 && image.channels != 4) ||
        static_cast<long long>(image.data.size()) != row * image.height ||
        row * image.height > std::numeric_limits<int>::max())
        return failed(fmt::format("cannot write '{}': {} x {} pixels of {} channels are no PNG image", path.string(),
                                  image.width, image.height, image.channels));
    const Result<std::string> bytes = encode_png(image, texts);
    if (!bytes) return failed(fmt::format("cannot write '{}': {}", path.string(), bytes.error().message()));
    return write_text_atomically(path, *bytes);
}

}  // namespace

Status save_png(const std::filesystem::path& path, const Image<unsigned char>& image,
                const std::map<std::string, std::string>& texts) {
    return save_png_of(path, image, texts);
}
Status save_png16(const std::filesystem::path& path, const Image<unsigned short>& image,
                  const std::map<std::string, std::string>& texts) {
    return save_png_of(path, image, texts);
}

Status save_jpeg(const std::filesystem::path& path, const Image<unsigned char>& image, const std::string& comment,
                 int quality, const std::map<std::string, std::string>& texts) {
    constexpr int kMostSide = 65500;           // libjpeg's
    constexpr std::size_t kMostKeyword = 100;  // bytes that a keyword and the line's end leave free
    const auto samples = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 3;
    if (image.width <= 0 || image.height <= 0 || image.width > kMostSide || image.height > kMostSide ||
        image.channels != 3 || image.data.size() != samples || comment.size() > kMostMarkerBytes)
        return failed(fmt::format("cannot write '{}': {} x {} pixels of {} channels are no JPEG image", path.string(),
                                  image.width, image.height, image.channels));
    Texts others = texts;
    const auto xmp = others.extract(kXmpWord);
    std::vector<std::string> comments;
    for (const auto& [keyword, text] : in_pieces(others, kMostMarkerBytes - kMostKeyword))
        comments.push_back(fmt::format("{}\n{}", keyword, text));
    if (!comment.empty()) comments.push_back(comment);  // last: the one that most readers show
    const Result<std::string> bytes = encode_jpeg(image, comments, quality, xmp.empty() ? "" : xmp.mapped());
    if (!bytes) return failed(fmt::format("cannot write '{}': {}", path.string(), bytes.error().message()));
    return write_text_atomically(path, *bytes);
}

float srgb_from_linear(float linear) {
    if (!(linear > 0.0f)) return 0.0f;  // also NaN
    if (linear >= 1.0f) return 1.0f;
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

std::vector<unsigned char> rgba8_of(const Image<float>& image) {
    std::vector<unsigned char> rgba;
    rgba.reserve(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const float* pixel = image.at(x, y);
            for (int c = 0; c < 3; ++c)
                rgba.push_back(static_cast<unsigned char>(std::lround(255.0f * srgb_from_linear(pixel[c]))));
            const float alpha = image.channels > 3 ? std::clamp(pixel[3], 0.0f, 1.0f) : 1.0f;
            rgba.push_back(static_cast<unsigned char>(std::lround(255.0f * alpha)));
        }
    return rgba;
}

float linear_from_srgb(float encoded) {
    if (!(encoded > 0.0f)) return 0.0f;
    if (encoded >= 1.0f) return 1.0f;
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

}  // namespace nullscope
