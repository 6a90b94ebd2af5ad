#include "image/large_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <utility>

#include "base/atomic_file.h"
#include "base/progress.h"
#include "base/text.h"
#include "image/area_filter.h"
#include "image/image_file.h"
#include "image/image_formats.h"

namespace nullscope {
namespace {

constexpr std::size_t kMaxLargeFileBytes = std::numeric_limits<int>::max();  // of a file that is held whole
constexpr long long kMaxWhole = 500'000'000;                                 // px of such a file

// What reads a file that begins with this byte row by row; nullptr: nothing does. libpng and libjpeg look at the rest
// of its signature.
using OpenRows = Result<std::unique_ptr<RowReader>> (*)(ByteSource source);
OpenRows rows_of(int first_byte) {
    return first_byte == 0x89 ? open_png_rows : first_byte == 0xff ? open_jpeg_rows : nullptr;
}

Result<FittedImage> read_rows(OpenRows open, ByteSource source, unsigned long long file_bytes, const std::string& name,
                              const ImageLimits& limits) {
    auto opened = open(std::move(source));
    if (!opened) return unreadable(name, opened.error().message());
    RowReader& rows = **opened;
    const long long pixels = static_cast<long long>(rows.width) * rows.height;
    if (pixels > limits.max_pixels)
        return unreadable(
            name, fmt::format("{} x {} pixels, at most {} are allowed", rows.width, rows.height, limits.max_pixels));
    if (!plausible_size(pixels * rows.channels, file_bytes))
        return unreadable(name, fmt::format("{} x {} pixels are not in {} bytes", rows.width, rows.height, file_bytes));
    if (rows.whole != nullptr && pixels > std::min(limits.whole_pixels, kMaxWhole)) return unreadable(name, rows.whole);
    const FittedSize size = fitted_size(rows.width, rows.height, limits.max_side);
    const bool reduced = size.width != rows.width || size.height != rows.height;
    FittedImage fitted{{}, rows.width, rows.height};
    std::optional<AreaFilter> filter;
    std::vector<float> row(static_cast<std::size_t>(rows.width) * rows.channels);
    if (reduced)
        filter.emplace(rows.width, rows.height, rows.channels, size.width, size.height);
    else
        fitted.image = Image<float>(rows.width, rows.height, rows.channels);
    Progress progress("reading " + std::filesystem::path(name).filename().string(), rows.height);
    for (int y = 0; y < rows.height; ++y, progress.advance()) {
        float* to = filter ? row.data() : fitted.image.at(0, y);
        if (Status read = rows.next(to); !read) return unreadable(name, read.error().message());
        if (filter) filter->add_row(to);
    }
    if (filter) fitted.image = filter->take();
    return fitted;
}

FittedImage made_smaller(Image<float> image, int max_side) {
    const int width = image.width, height = image.height;
    const FittedSize size = fitted_size(width, height, max_side);
    if (size.width == width && size.height == height) return {std::move(image), width, height};
    AreaFilter filter(width, height, image.channels, size.width, size.height);
    for (int y = 0; y < height; ++y) filter.add_row(image.at(0, y));
    return {filter.take(), width, height};
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

Error unreadable(const std::string& name, std::string_view reason) {
    return bad_input(without_controls(fmt::format("cannot read image '{}': {}", name, reason)));
}

Result<FittedImage> load_fitted_image(const std::filesystem::path& path, const ImageLimits& limits) {
    if (lower_case(path.extension().string()) == ".exr") {
        TRY(exr, load_exr(path, std::min(limits.max_pixels, kMaxWhole)));
        TRY(image, image_from_exr(path.string(), *exr));
        return made_smaller(std::move(*image), limits.max_side);
    }
    std::error_code error;
    const auto file_bytes = std::filesystem::file_size(path, error);  // an error: no file, or a pipe
    std::ifstream file(path, std::ios::binary);
    if (const OpenRows open = error ? nullptr : rows_of(file.peek())) {
        const ByteSource source = [&file](char* to, std::size_t most) {
            file.read(to, static_cast<std::streamsize>(most));
            return static_cast<std::size_t>(file.gcount());
        };
        return read_rows(open, source, file_bytes, path.string(), limits);
    }
    TRY(bytes, read_text(path, kMaxLargeFileBytes));
    return decode_fitted_image(*bytes, path.string(), limits);
}

Result<FittedImage> decode_fitted_image(std::string_view bytes, const std::string& name, const ImageLimits& limits) {
    if (const OpenRows open = bytes.empty() ? nullptr : rows_of(static_cast<unsigned char>(bytes.front()))) {
        const ByteSource source = [rest = bytes](char* to, std::size_t most) mutable {
            const std::size_t size = rest.copy(to, most);
            rest.remove_prefix(size);
            return size;
        };
        return read_rows(open, source, bytes.size(), name, limits);
    }
    if (!is_hdr(bytes)) return unreadable(name, "not a PNG, JPEG, HDR or EXR file");
    auto image = decode_hdr(bytes, std::min(limits.max_pixels, kMaxWhole));
    if (!image) return unreadable(name, image.error().message());
    return made_smaller(std::move(*image), limits.max_side);
}

std::string reduction_words(const std::filesystem::path& path, const FittedImage& image, const std::string& why) {
    if (!image.reduced()) return "";
    return without_controls(fmt::format("'{}': {}x{} px, read as {}x{} px: {}", path.string(), image.width,
                                        image.height, image.image.width, image.image.height, why));
}

}  // namespace nullscope
