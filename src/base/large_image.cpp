#include "base/large_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <utility>

#include "base/area_filter.h"
#include "base/image_file.h"
#include "base/progress.h"
#include "base/row_reader.h"
#include "base/text.h"

namespace nullscope {
namespace {

constexpr std::string_view kPngMagic = "\x89PNG\r\n\x1a\n", kJpegMagic = "\xff\xd8\xff";
constexpr std::size_t kHeadBytes = 1 << 20;  // where a PNG's or JPEG's size is found without its decoder

Error unreadable(const std::string& name, std::string_view reason) {
    return bad_input(without_controls(fmt::format("cannot read image '{}': {}", name, reason)));
}

unsigned number_at(std::string_view bytes, std::size_t at, std::size_t count) {
    unsigned value = 0;
    for (std::size_t i = 0; i < count; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

// What the header announces; 0 where that is not known. PNG: the first chunk. JPEG: the frame's segment (C0 to CF but DHT, JPG, DAC).
long long announced_pixels(std::string_view head) {
    if (head.starts_with(kPngMagic)) {
        constexpr std::size_t kWidth = 16, kEnd = 24;
        constexpr unsigned kMost = 0x7fffffff;  // PNG's own limit: the product of two fits
        if (head.size() < kEnd) return 0;
        return static_cast<long long>(std::min(number_at(head, kWidth, 4), kMost)) *
               std::min(number_at(head, kWidth + 4, 4), kMost);
    }
    if (!head.starts_with(kJpegMagic)) return 0;
    for (std::size_t at = 2; at + 9 <= head.size();) {
        if (head[at] != '\xff') return 0;
        const unsigned kind = static_cast<unsigned char>(head[at + 1]);
        if (kind == 0xff) {  // padding
            ++at;
            continue;
        }
        if (kind >= 0xc0 && kind <= 0xcf && kind != 0xc4 && kind != 0xc8 && kind != 0xcc)
            return static_cast<long long>(number_at(head, at + 5, 2)) * number_at(head, at + 7, 2);
        at += 2 + number_at(head, at + 2, 2);
    }
    return 0;
}

bool by_rows(std::string_view head, const ImageLimits& limits) {
    if (!head.starts_with(kPngMagic) && !head.starts_with(kJpegMagic)) return false;
    const long long pixels = announced_pixels(head);
    // A JPEG whose size lies beyond a long head of other things is read by rows too: safe for any size.
    return pixels > limits.whole_pixels || (pixels == 0 && head.starts_with(kJpegMagic));
}

Result<FittedImage> read_rows(std::string_view head, ByteSource source, unsigned long long file_bytes,
                              const std::string& name, const ImageLimits& limits) {
    auto opened = head.starts_with(kPngMagic) ? open_png_rows(std::move(source)) : open_jpeg_rows(std::move(source));
    if (!opened) return unreadable(name, opened.error().message);
    RowReader& rows = **opened;
    if (static_cast<long long>(rows.width) * rows.height > limits.max_pixels)
        return unreadable(
            name, fmt::format("{} x {} pixels, at most {} are allowed", rows.width, rows.height, limits.max_pixels));
    if (!plausible_size(static_cast<long long>(rows.width) * rows.height * rows.channels, file_bytes))
        return unreadable(name, fmt::format("{} x {} pixels are not in {} bytes", rows.width, rows.height, file_bytes));
    const FittedSize size = fitted_size(rows.width, rows.height, limits.max_side);
    AreaFilter filter(rows.width, rows.height, rows.channels, size.width, size.height);
    std::vector<float> row(static_cast<std::size_t>(rows.width) * rows.channels);
    Progress progress("reading " + std::filesystem::path(name).filename().string(), rows.height);
    for (int y = 0; y < rows.height; ++y, progress.advance()) {
        if (Status read = rows.next(row.data()); !read) return unreadable(name, read.error().message);
        filter.add_row(row.data());
    }
    return FittedImage{filter.take(), rows.width, rows.height};
}

FittedImage made_smaller(Image<float> image, int max_side) {
    const int width = image.width, height = image.height;
    const FittedSize size = fitted_size(width, height, max_side);
    if (size.width == width && size.height == height) return {std::move(image), width, height};
    AreaFilter filter(width, height, image.channels, size.width, size.height);
    for (int y = 0; y < height; ++y) filter.add_row(image.at(0, y));
    return {filter.take(), width, height};
}

}  // namespace

Result<FittedImage> load_fitted_image(const std::filesystem::path& path, const ImageLimits& limits) {
    std::ifstream file(path, std::ios::binary);
    std::string head(kHeadBytes, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
    std::error_code error;
    const auto bytes = std::filesystem::file_size(path, error);
    if (!error && by_rows(head, limits)) {
        file.clear();
        file.seekg(0);
        const ByteSource source = [&file](char* to, std::size_t most) {
            file.read(to, static_cast<std::streamsize>(most));
            return static_cast<std::size_t>(file.gcount());
        };
        return read_rows(head, source, bytes, path.string(), limits);
    }
    auto image = load_image(path);
    if (!image) return image.error();
    return made_smaller(std::move(*image), limits.max_side);
}

Result<FittedImage> decode_fitted_image(std::string_view bytes, const std::string& name, const ImageLimits& limits) {
    if (by_rows(bytes.substr(0, kHeadBytes), limits)) {
        std::string_view rest = bytes;
        const ByteSource source = [&rest](char* to, std::size_t most) {
            const std::size_t size = std::min(most, rest.size());
            std::memcpy(to, rest.data(), size);
            rest.remove_prefix(size);
            return size;
        };
        return read_rows(bytes, source, bytes.size(), name, limits);
    }
    auto image = decode_image(bytes, name, std::min(limits.max_pixels, 500'000'000LL));
    if (!image) return image.error();
    return made_smaller(std::move(*image), limits.max_side);
}

std::string reduction_words(const std::filesystem::path& path, const FittedImage& image, const std::string& why) {
    if (!image.reduced()) return "";
    return without_controls(fmt::format("'{}': {}x{} px, read as {}x{} px: {}", path.string(), image.width,
                                        image.height, image.image.width, image.image.height, why));
}

}  // namespace nullscope
