#include "image/large_image.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <utility>

#include "base/atomic_file.h"
#include "base/progress.h"
#include "base/text.h"
#include "image/area_filter.h"
#include "image/half_float.h"
#include "image/image_file.h"
#include "image/image_formats.h"
#include "image/orientation.h"

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

// Of files that are held whole; the first that takes one reads it.
struct WholeReader {
    bool (*is)(std::string_view bytes);
    Result<WholePicture> (*decode)(std::string_view bytes, long long max_pixels);
};
constexpr WholeReader kWholeReaders[] = {
    {is_hdr, decode_hdr}, {is_tiff, decode_tiff}, {is_pnm, decode_pnm}, {is_by_stb, decode_stb}};

bool is_exr(const std::filesystem::path& path) { return lower_case(path.extension().string()) == ".exr"; }

// A file's picture as it was decoded, before it is turned.
struct Decoded {
    FittedImage fitted;
    int orientation = 1;
    std::optional<Mat3> to_rec709{};
    std::vector<std::string> unused{};
};

void convert(Image<float>& image, const Mat3& to_rec709) {
    for (std::size_t i = 0; i + 2 < image.data.size(); i += static_cast<std::size_t>(image.channels)) {
        float* pixel = image.data.data() + i;
        const Vec3 light = to_rec709 * Vec3{pixel[0], pixel[1], pixel[2]};
        pixel[0] = static_cast<float>(light.x), pixel[1] = static_cast<float>(light.y);
        pixel[2] = static_cast<float>(light.z);
    }
}

// What is no light becomes some: told of by number.
void mend_light(Image<float>& image, std::vector<std::string>& notes) {
    float largest = kMostHalf, lowest = 0.0f;
    std::size_t below = 0, infinite = 0, no_number = 0;
    for (const float light : image.data)
        if (std::isfinite(light)) largest = std::max(largest, light);
    for (float& light : image.data) {
        if (std::isnan(light))
            ++no_number, light = 0.0f;
        else if (light < 0.0f)
            ++below, lowest = std::min(lowest, light), light = 0.0f;
        else if (std::isinf(light))
            ++infinite, light = largest;
    }
    if (below > 0) notes.push_back(fmt::format("{} numbers below 0, the lowest {:.3g}, are read as 0", below, lowest));
    if (no_number > 0) notes.push_back(fmt::format("{} numbers that are NaN are read as 0", no_number));
    if (infinite > 0) notes.push_back(fmt::format("{} infinite numbers are read as {:g}", infinite, largest));
}

// False: every pixel is opaque.
bool put_on_black(FittedImage& fitted, Alpha alpha) {
    const Image<float>& from = fitted.image;
    bool clear = false;
    Image<float> to(from.width, from.height, 3);
    for (std::size_t i = 0; 4 * i < from.data.size(); ++i) {
        clear = clear || from.data[4 * i + 3] < 1.0f;
        for (std::size_t c = 0; c < 3; ++c)
            to.data[3 * i + c] = (alpha == Alpha::kOnBlack ? from.data[4 * i + 3] : 1.0f) * from.data[4 * i + c];
    }
    fitted.image = std::move(to);
    return clear;
}

FittedImage finished(Decoded decoded, const std::string& name, const ImageLimits& limits) {
    FittedImage& fitted = decoded.fitted;
    if (decoded.to_rec709) convert(fitted.image, *decoded.to_rec709);
    if (decoded.to_rec709 && limits.light) mend_light(fitted.image, fitted.notes);
    if (fitted.image.channels == 4 && limits.alpha != Alpha::kKept) {
        const bool clear = put_on_black(fitted, limits.alpha);
        if (clear && limits.alpha == Alpha::kLeftOut) decoded.unused.emplace_back("alpha");
    }
    if (decoded.orientation != 1) fitted.image = turned(fitted.image, decoded.orientation);
    if (decoded.orientation >= 5) std::swap(fitted.width, fitted.height);
    if (!decoded.unused.empty()) fitted.notes.push_back(fmt::format("not used: {}", fmt::join(decoded.unused, "; ")));
    for (std::string& note : fitted.notes) note = without_controls(fmt::format("'{}': {}", name, note));
    return std::move(fitted);
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
    Decoded decoded{{{}, rows.width, rows.height}, rows.orientation, rows.to_rec709, rows.unused};
    FittedImage& fitted = decoded.fitted;
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
    return finished(std::move(decoded), name, limits);
}

// Of an image that is held whole.
FittedImage made_smaller(Decoded decoded, const std::string& name, const ImageLimits& limits) {
    FittedImage& fitted = decoded.fitted;
    Image<float>& image = fitted.image;
    fitted.width = image.width, fitted.height = image.height;
    if (decoded.to_rec709) convert(image, *std::exchange(decoded.to_rec709, {}));
    if (limits.light) mend_light(image, fitted.notes);
    const FittedSize size = fitted_size(image.width, image.height, limits.max_side);
    if (fitted.width != size.width || fitted.height != size.height) {
        AreaFilter filter(image.width, image.height, image.channels, size.width, size.height);
        for (int y = 0; y < image.height; ++y) filter.add_row(image.at(0, y));
        image = filter.take();
    }
    return finished(std::move(decoded), name, limits);
}

// Colours that are multiplied by alpha become those that are not: a pixel without alpha that glows has none.
void divide_by_alpha(Decoded& decoded) {
    Image<float>& image = decoded.fitted.image;
    std::size_t lost = 0;
    for (std::size_t i = 0; i < image.data.size(); i += 4) {
        float* pixel = image.data.data() + i;
        const bool glows = pixel[0] > 0.0f || pixel[1] > 0.0f || pixel[2] > 0.0f;
        if (!(pixel[3] > 0.0f) && glows) ++lost;
        for (std::size_t c = 0; c < 3; ++c) pixel[c] = pixel[3] > 0.0f ? pixel[c] / pixel[3] : 0.0f;
    }
    if (lost > 0) decoded.unused.push_back(fmt::format("the light of {} pixels whose alpha is 0", lost));
}

Result<FittedImage> load_fitted_exr(const std::filesystem::path& path, const ImageLimits& limits) {
    const bool with_alpha = limits.alpha == Alpha::kKept;
    TRY(exr, load_exr_picture(path, std::min(limits.max_pixels, kMaxWhole), with_alpha, limits.layer));
    Decoded decoded{{std::move(exr->image)}, 1, exr->to_rec709, std::move(exr->unused)};
    if (exr->has_alpha && limits.alpha == Alpha::kLeftOut) decoded.unused.emplace_back("alpha");
    if (decoded.fitted.image.channels == 4 && limits.light) divide_by_alpha(decoded);
    return made_smaller(std::move(decoded), path.string(), limits);
}

}  // namespace

Error unreadable(const std::string& name, std::string_view reason) {
    return bad_input(without_controls(fmt::format("cannot read image '{}': {}", name, reason)));
}

Result<FittedImage> load_fitted_image(const std::filesystem::path& path, const ImageLimits& limits) {
    if (is_exr(path)) return load_fitted_exr(path, limits);
    if (!limits.layer.empty()) return unreadable(path.string(), "image_layer is of EXR files");
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
    const auto* reader = std::ranges::find_if(kWholeReaders, [&](const WholeReader& r) { return r.is(bytes); });
    if (reader == std::end(kWholeReaders))
        return unreadable(name, "not a PNG, JPEG, HDR, TIFF, EXR, PNM, BMP, PSD or TGA file");
    auto whole = reader->decode(bytes, std::min(limits.max_pixels, kMaxWhole));
    if (!whole) return unreadable(name, whole.error().message());
    return made_smaller({{std::move(whole->image)}, whole->orientation, whole->to_rec709, std::move(whole->unused)},
                        name, limits);
}

Result<ImageSize> image_size(const std::filesystem::path& path, const std::string& layer) {
    std::ifstream file(path, std::ios::binary);
    const OpenRows open = is_exr(path) ? nullptr : rows_of(file.peek());
    if (open == nullptr) {
        TRY(whole, load_fitted_image(path, {.layer = layer}));
        return ImageSize{whole->width, whole->height};
    }
    auto rows = open([&file](char* to, std::size_t most) {
        file.read(to, static_cast<std::streamsize>(most));
        return static_cast<std::size_t>(file.gcount());
    });
    if (!rows) return unreadable(path.string(), rows.error().message());
    const bool lies = (*rows)->orientation >= 5;
    return ImageSize{lies ? (*rows)->height : (*rows)->width, lies ? (*rows)->width : (*rows)->height};
}

std::string reduction_words(const std::filesystem::path& path, const FittedImage& image, const std::string& why) {
    if (!image.reduced()) return "";
    return without_controls(fmt::format("'{}': {}x{} px, read as {}x{} px: {}", path.string(), image.width,
                                        image.height, image.image.width, image.image.height, why));
}

}  // namespace nullscope
