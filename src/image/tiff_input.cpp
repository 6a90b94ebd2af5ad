// TIFF (revision 6.0, and BigTIFF) as pictures, by libtiff: grey and RGB of 8 or 16 bits, sRGB-encoded, and of floats, linear light, in strips
// or tiles; what libtiff itself turns into 8 bits (palettes, YCbCr, CMYK) too. The first page.
#include <fmt/format.h>
#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "image/image_file.h"
#include "image/image_formats.h"

namespace nullscope {
namespace {

constexpr tmsize_t kMostAtOnce = tmsize_t{1} << 29;  // bytes that libtiff may ask for, and of a row or tile

struct Source {
    std::string_view bytes{};
    std::size_t at = 0;
    std::string fault{};
};

tmsize_t read_some(thandle_t handle, void* to, tmsize_t count) {
    auto& file = *static_cast<Source*>(handle);
    const std::size_t size =
        file.bytes.copy(static_cast<char*>(to), static_cast<std::size_t>(std::max<tmsize_t>(count, 0)),
                        std::min(file.at, file.bytes.size()));
    file.at += size;
    return static_cast<tmsize_t>(size);
}
toff_t seek_to(thandle_t handle, toff_t to, int from) {
    auto& file = *static_cast<Source*>(handle);
    return file.at = (from == SEEK_SET ? 0 : from == SEEK_CUR ? file.at : file.bytes.size()) + to;
}
int keep_error(TIFF*, void* handle, const char*, const char* words, std::va_list values) {
    std::array<char, 200> text{};
    std::vsnprintf(text.data(), text.size(), words, values);
    auto& fault = static_cast<Source*>(handle)->fault;
    if (fault.empty()) fault = text.data();
    return 1;
}

struct CloseTiff {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using OpenedTiff = std::unique_ptr<TIFF, CloseTiff>;

OpenedTiff open_source(Source& file) {
    TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
    if (options == nullptr) throw std::bad_alloc();
    TIFFOpenOptionsSetErrorHandlerExtR(options, keep_error, &file);
    TIFFOpenOptionsSetWarningHandlerExtR(
        options, [](TIFF*, void*, const char*, const char*, std::va_list) { return 1; }, nullptr);
    TIFFOpenOptionsSetMaxSingleMemAlloc(options, kMostAtOnce);
    TIFF* tiff = TIFFClientOpenExt(
        "picture", "rm", &file, read_some, [](thandle_t, void*, tmsize_t) { return tmsize_t{0}; }, seek_to,
        [](thandle_t) { return 0; },
        [](thandle_t handle) { return toff_t{static_cast<Source*>(handle)->bytes.size()}; }, nullptr, nullptr, options);
    TIFFOpenOptionsFree(options);
    return OpenedTiff(tiff);
}

// What the first page says of its numbers.
struct Kind {
    std::uint32_t width = 0, height = 0;
    std::uint16_t bits = 1, samples = 1, format = SAMPLEFORMAT_UINT, light = 0xffff, planes = PLANARCONFIG_CONTIG;
    bool alpha = false, multiplied = false, tiled = false;
    int colours() const { return light == PHOTOMETRIC_RGB ? 3 : 1; }
    bool floats() const { return format == SAMPLEFORMAT_IEEEFP; }
    std::size_t pixel() const { return static_cast<std::size_t>(samples) * bits / 8; }  // bytes
    bool plain() const {
        const bool number = floats() ? bits == 32 : format == SAMPLEFORMAT_UINT && (bits == 8 || bits == 16);
        return number && planes == PLANARCONFIG_CONTIG && samples >= colours() && samples <= 16 &&
               (light == PHOTOMETRIC_RGB || light == PHOTOMETRIC_MINISBLACK);
    }
};

Kind kind_of(TIFF* tiff) {
    Kind kind;
    TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &kind.width), TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &kind.height);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &kind.bits);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &kind.samples);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &kind.format);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_PLANARCONFIG, &kind.planes);
    TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &kind.light);
    std::uint16_t extra = 0, *kinds = nullptr;
    TIFFGetFieldDefaulted(tiff, TIFFTAG_EXTRASAMPLES, &extra, &kinds);
    kind.multiplied = extra > 0 && kinds[0] == EXTRASAMPLE_ASSOCALPHA;
    kind.alpha =
        kind.samples > kind.colours() && (kind.multiplied || (extra > 0 && kinds[0] == EXTRASAMPLE_UNASSALPHA));
    kind.tiled = TIFFIsTiled(tiff) != 0;
    return kind;
}

// Pixels of one row into linear light, not multiplied by alpha.
class Converter {
public:
    explicit Converter(const Kind& kind) : kind_(kind), most_(kind.bits == 8 ? 255.0f : 65535.0f) {
        for (int i = 0; !kind.floats() && i < 1 << kind.bits; ++i)
            table_.push_back(linear_from_srgb(static_cast<float>(i) / most_));
    }
    void convert(const unsigned char* from, int count, float* to) const {
        for (int x = 0; x < count; ++x, from += kind_.pixel()) {
            const float alpha = kind_.alpha ? share(from, kind_.colours()) : 1.0f;
            for (int c = 0; c < 3; ++c) *to++ = light(from, kind_.colours() == 3 ? c : 0, alpha);
            if (kind_.alpha) *to++ = alpha;
        }
    }

private:
    unsigned code(const unsigned char* from, int c) const {
        if (kind_.bits == 8) return from[c];
        std::uint16_t value = 0;
        std::memcpy(&value, from + 2 * c, sizeof(value));
        return value;
    }
    float share(const unsigned char* from, int c) const {
        if (!kind_.floats()) return static_cast<float>(code(from, c)) / most_;
        float value = 0.0f;
        std::memcpy(&value, from + 4 * c, sizeof(value));
        return value;
    }
    float light(const unsigned char* from, int c, float alpha) const {
        if (!kind_.multiplied || !kind_.alpha) return kind_.floats() ? share(from, c) : table_[code(from, c)];
        if (!(alpha > 0.0f)) return 0.0f;
        const float value = share(from, c) / alpha;  // codes are multiplied as they are stored
        return kind_.floats() ? value : linear_from_srgb(value);
    }
    const Kind& kind_;
    float most_;
    std::vector<float> table_;
};

bool read_strips(TIFF* tiff, const Kind& kind, Image<float>& image) {
    const Converter converter(kind);
    const auto size = static_cast<std::size_t>(std::max<tmsize_t>(TIFFScanlineSize(tiff), 0));
    if (size < kind.pixel() * kind.width || size > kMostAtOnce) return false;
    std::vector<unsigned char> row(size);
    for (std::uint32_t y = 0; y < kind.height; ++y) {
        if (TIFFReadScanline(tiff, row.data(), y, 0) < 0) return false;
        converter.convert(row.data(), image.width, image.at(0, static_cast<int>(y)));
    }
    return true;
}

bool read_tiles(TIFF* tiff, const Kind& kind, Image<float>& image) {
    const Converter converter(kind);
    std::uint32_t width = 0, height = 0;
    TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &width), TIFFGetField(tiff, TIFFTAG_TILELENGTH, &height);
    const auto size = static_cast<std::size_t>(std::max<tmsize_t>(TIFFTileSize(tiff), 0));
    if (width == 0 || height == 0 || size > kMostAtOnce || size / kind.pixel() / width < height) return false;
    std::vector<unsigned char> tile(size);
    for (std::uint32_t top = 0; top < kind.height; top += height)
        for (std::uint32_t left = 0; left < kind.width; left += width) {
            if (TIFFReadTile(tiff, tile.data(), left, top, 0, 0) < 0) return false;
            const std::uint32_t columns = std::min(width, kind.width - left),
                                rows = std::min(height, kind.height - top);
            for (std::uint32_t y = 0; y < rows; ++y)
                converter.convert(tile.data() + kind.pixel() * width * y, static_cast<int>(columns),
                                  image.at(static_cast<int>(left), static_cast<int>(top + y)));
        }
    return true;
}

// By libtiff's own conversion; the lowest byte is red.
bool read_converted(TIFF* tiff, const Kind& kind, Image<float>& image) {
    std::vector<std::uint32_t> pixels(static_cast<std::size_t>(kind.width) * kind.height);
    if (TIFFReadRGBAImageOriented(tiff, kind.width, kind.height, pixels.data(), ORIENTATION_TOPLEFT, 1) == 0)
        return false;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            image.data[3 * i + c] = linear_from_srgb(static_cast<float>(pixels[i] >> 8 * c & 255) / 255.0f);
    return true;
}

std::vector<std::string> unused_of(TIFF* tiff, const Kind& kind) {
    std::vector<std::string> unused;
    std::uint32_t size = 0;
    void* profile = nullptr;
    if (TIFFGetField(tiff, TIFFTAG_ICCPROFILE, &size, &profile) != 0 &&
        !is_srgb_profile({static_cast<const char*>(profile), size}))
        unused.emplace_back(kind.floats() ? "colour profile: read as linear Rec. 709" : "colour profile: read as sRGB");
    const int others = kind.samples - kind.colours() - (kind.alpha ? 1 : 0);
    if (kind.plain() && others > 0) unused.push_back(fmt::format("{} further channels", others));
    if (TIFFLastDirectory(tiff) == 0) unused.emplace_back("pages after the first");
    return unused;
}

}  // namespace

bool is_tiff(std::string_view bytes) {
    for (const std::string_view mark : {std::string_view("II*\0", 4), {"MM\0*", 4}, {"II+\0", 4}, {"MM\0+", 4}})
        if (bytes.starts_with(mark)) return true;
    return false;
}

Result<WholePicture> decode_tiff(std::string_view bytes, long long max_pixels) {
    Source file{bytes};
    const OpenedTiff tiff = open_source(file);
    const auto damaged = [&] { return bad_input("libtiff: " + (file.fault.empty() ? "damaged" : file.fault)); };
    if (tiff == nullptr) return damaged();
    const Kind kind = kind_of(tiff.get());
    const long long pixels = static_cast<long long>(kind.width) * kind.height;
    constexpr std::uint32_t kMostSide = 1'000'000;
    if (pixels == 0 || kind.width > kMostSide || kind.height > kMostSide || pixels > max_pixels)
        return bad_input(fmt::format("{} x {} pixels, at most {} are allowed", kind.width, kind.height, max_pixels));
    if (!plausible_size(pixels * kind.samples, bytes.size()))
        return bad_input(fmt::format("{} x {} pixels are not in {} bytes", kind.width, kind.height, bytes.size()));
    std::array<char, 1024> why{};
    if (!kind.plain() && TIFFRGBAImageOK(tiff.get(), why.data()) == 0)
        return bad_input(fmt::format("TIFF of {} bits, {} samples, photometric {}: {}", kind.bits, kind.samples,
                                     kind.light, why.data()),
                         "grey or RGB of 8 or 16 bits or 32-bit floats, channels together");
    WholePicture picture;
    picture.image =
        Image<float>(static_cast<int>(kind.width), static_cast<int>(kind.height), kind.plain() && kind.alpha ? 4 : 3);
    const auto read = !kind.plain() ? read_converted : kind.tiled ? read_tiles : read_strips;
    if (!read(tiff.get(), kind, picture.image)) return damaged();
    std::uint16_t turn = 1;
    TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_ORIENTATION, &turn);
    if (kind.plain() && turn >= 1 && turn <= 8) picture.orientation = turn;
    picture.unused = unused_of(tiff.get(), kind);
    return picture;
}

}  // namespace nullscope
