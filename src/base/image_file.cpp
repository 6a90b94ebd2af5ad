#include "base/image_file.h"

#include <fmt/format.h>
#include <stb_image.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string_view>

#include "base/atomic_file.h"
#include "base/exr_file.h"
#include "base/hdr_file.h"
#include "base/jpeg_check.h"
#include "base/png_check.h"
#include "base/png_encoder.h"
#include "base/text.h"

namespace nullscope {
namespace {

constexpr std::size_t kMaxFileBytes = std::numeric_limits<int>::max();  // stb counts bytes in int
constexpr std::string_view kPngMagic = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kJpegMagic = "\xff\xd8\xff";

template <class T>
using StbPixels = std::unique_ptr<T, decltype(&stbi_image_free)>;

struct Source {
    const stbi_uc* bytes;
    int size;
};

// Every code value's linear light.
template <class T>
std::vector<float> decoding_table() {
    std::vector<float> table(std::size_t{std::numeric_limits<T>::max()} + 1);
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = linear_from_srgb(static_cast<float>(i) / static_cast<float>(table.size() - 1));
    return table;
}

// Grey is repeated to three channels; a last channel of 2 or 4 is alpha, which is linear.
template <class T>
Image<float> linear_image(const T* pixels, int width, int height, int components) {
    const std::vector<float> table = decoding_table<T>();
    const bool alpha = components == 2 || components == 4;
    const int colours = alpha ? components - 1 : components;
    Image<float> image(width, height, alpha ? 4 : 3);
    float* out = image.data.data();
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    for (std::size_t i = 0; i < count; ++i, pixels += components) {
        for (int c = 0; c < 3; ++c) *out++ = table[pixels[std::min(c, colours - 1)]];
        if (alpha) *out++ = static_cast<float>(pixels[colours]) / static_cast<float>(std::numeric_limits<T>::max());
    }
    return image;
}

Error unreadable(const std::string& name, std::string_view reason) {
    return bad_input(without_controls(fmt::format("cannot read image '{}': {}", name, reason)));
}

Error stb_error(const std::string& name) {
    const char* reason = stbi_failure_reason();
    return unreadable(name, reason ? reason : "not an image");
}

Result<Image<float>> decode_by_stb(const std::string& name, const Source& source) {
    int w = 0, h = 0, n = 0;
    if (stbi_is_16_bit_from_memory(source.bytes, source.size)) {
        const StbPixels<stbi_us> pixels(stbi_load_16_from_memory(source.bytes, source.size, &w, &h, &n, 0),
                                        stbi_image_free);
        if (!pixels) return stb_error(name);
        return linear_image(pixels.get(), w, h, n);
    }
    const StbPixels<stbi_uc> pixels(stbi_load_from_memory(source.bytes, source.size, &w, &h, &n, 0), stbi_image_free);
    if (!pixels) return stb_error(name);
    return linear_image(pixels.get(), w, h, n);
}

// R, G, B, or Y for all three; A if present.
Result<Image<float>> image_from_exr(const std::string& name, const ChannelImage& exr) {
    const bool grey = !exr.channels.count("R") && exr.channels.count("Y");
    std::vector<const float*> planes;
    for (const char* colour : {"R", "G", "B"}) {
        const auto found = exr.channels.find(grey ? "Y" : colour);
        if (found == exr.channels.end()) return unreadable(name, fmt::format("no channel {}", colour));
        planes.push_back(found->second.data());
    }
    if (const auto alpha = exr.channels.find("A"); alpha != exr.channels.end()) planes.push_back(alpha->second.data());
    Image<float> image(exr.width, exr.height, static_cast<int>(planes.size()));
    const std::size_t count = image.data.size() / planes.size();
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < planes.size(); ++c) image.data[i * planes.size() + c] = planes[c][i];
    return image;
}

}  // namespace

Result<Image<float>> decode_image(std::string_view bytes, const std::string& name, long long max_pixels) {
    if (is_hdr(bytes)) {
        Result<Image<float>> image = decode_hdr(bytes, max_pixels);
        return image ? std::move(image) : unreadable(name, image.error().message);
    }
    // stb's other decoders accept nearly anything: only the formats of the contract reach it.
    if (!bytes.starts_with(kPngMagic) && !bytes.starts_with(kJpegMagic))
        return unreadable(name, "not a PNG, JPEG, HDR or EXR file");
    if (bytes.size() > kMaxFileBytes) return unreadable(name, "the file is too large");
    if (const Status checked = bytes.starts_with(kPngMagic) ? check_png(bytes) : check_jpeg(bytes); !checked)
        return unreadable(name, checked.error().message);
    const Source source{reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size())};
    int width = 0, height = 0, components = 0;
    if (!stbi_info_from_memory(source.bytes, source.size, &width, &height, &components))
        return unreadable(name, "its header is damaged, or announces more than the decoder takes");
    if (width <= 0 || height <= 0 || static_cast<long long>(width) * height > max_pixels)
        return unreadable(name, fmt::format("{} x {} pixels, at most {} are allowed", width, height, max_pixels));
    if (!plausible_size(static_cast<long long>(width) * height * components, bytes.size()))
        return unreadable(name, fmt::format("{} x {} pixels are not in {} bytes", width, height, bytes.size()));
    return decode_by_stb(name, source);
}

Result<Image<float>> load_image(const std::filesystem::path& path, long long max_pixels) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".exr") {
        const Result<ChannelImage> exr = load_exr_limited(path, max_pixels);
        if (!exr) return exr.error();
        return image_from_exr(path.string(), *exr);
    }
    const Result<std::string> bytes = read_text(path, kMaxFileBytes);
    if (!bytes) return bytes.error();
    return decode_image(*bytes, path.string(), max_pixels);
}

Status save_png(const std::filesystem::path& path, const Image<unsigned char>& image,
                const std::map<std::string, std::string>& texts) {
    const long long row_bytes = static_cast<long long>(image.width) * image.channels;
    if (image.width <= 0 || image.height <= 0 || (image.channels != 3 && image.channels != 4) ||
        static_cast<long long>(image.data.size()) != row_bytes * image.height ||
        row_bytes * image.height > std::numeric_limits<int>::max())
        return failed(fmt::format("cannot write '{}': {} x {} pixels of {} channels are no PNG image", path.string(),
                                  image.width, image.height, image.channels));
    const Result<std::string> bytes = encode_png(image, texts);
    if (!bytes) return failed(fmt::format("cannot write '{}': {}", path.string(), bytes.error().message));
    return write_text_atomically(path, *bytes);
}

float srgb_from_linear(float linear) {
    if (!(linear > 0.0f)) return 0.0f;  // also NaN
    if (linear >= 1.0f) return 1.0f;
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float linear_from_srgb(float encoded) {
    if (!(encoded > 0.0f)) return 0.0f;
    if (encoded >= 1.0f) return 1.0f;
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

}  // namespace nullscope
