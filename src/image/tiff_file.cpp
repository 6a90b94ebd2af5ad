// TIFF (revision 6.0) of 16 bits a colour, by libtiff. Colours are sRGB, which an ICC profile says; texts are in the ImageDescription.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/text.h"
#include "image/image_formats.h"
#include "image/picture_formats.h"

namespace nullscope {
namespace {

// A file in memory, and what libtiff says of it.
struct TiffBytes {
    std::string bytes{}, fault{};
    std::size_t at = 0;
};

tmsize_t read_bytes(thandle_t handle, void* to, tmsize_t count) {
    auto& file = *static_cast<TiffBytes*>(handle);
    const std::size_t size =
        file.bytes.copy(static_cast<char*>(to), static_cast<std::size_t>(count), std::min(file.at, file.bytes.size()));
    file.at += size;
    return static_cast<tmsize_t>(size);
}

tmsize_t write_bytes(thandle_t handle, void* from, tmsize_t count) {
    auto& file = *static_cast<TiffBytes*>(handle);
    const auto size = static_cast<std::size_t>(count);
    try {  // nothing may be thrown through libtiff
        if (file.at + size > file.bytes.size()) file.bytes.resize(file.at + size);
    } catch (const std::bad_alloc&) {
        file.fault = "out of memory";
        return 0;
    }
    std::memcpy(file.bytes.data() + file.at, from, size);
    file.at += size;
    return count;
}

toff_t seek_bytes(thandle_t handle, toff_t to, int from) {
    auto& file = *static_cast<TiffBytes*>(handle);
    const std::size_t start = from == SEEK_SET ? 0 : from == SEEK_CUR ? file.at : file.bytes.size();
    return file.at = start + to;
}

int on_tiff_error(TIFF*, void* file, const char*, const char* words, std::va_list values) {
    std::array<char, 200> text{};
    std::vsnprintf(text.data(), text.size(), words, values);
    auto& fault = static_cast<TiffBytes*>(file)->fault;
    if (fault.empty()) fault = text.data();
    return 1;
}

// A profile of the ICC (version 4) that says sRGB (IEC 61966-2-1): primaries adapted to D50, and the curve.
class SrgbProfile {
public:
    SrgbProfile() {
        const std::string white = fixed("XYZ ", {0.9642, 1.0, 0.8249});
        const std::string curve = "para" + number(0) + std::string("\0\3\0\0", 4) +
                                  fixed("", {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045});
        add("desc", words("sRGB IEC61966-2.1")), add("cprt", words("No copyright")), add("wtpt", white);
        add("rXYZ", fixed("XYZ ", {0.43607, 0.22249, 0.01392})),
            add("gXYZ", fixed("XYZ ", {0.38515, 0.71687, 0.09708}));
        add("bXYZ", fixed("XYZ ", {0.14307, 0.06061, 0.71410}));
        add("chad", fixed("sf32", {1.04791, 0.02293, -0.0502, 0.0296, 0.99046, -0.01707, -0.00925, 0.01506, 0.75179}));
        for (const char* name : {"rTRC", "gTRC", "bTRC"}) add(name, curve);
    }
    std::string bytes() const {
        constexpr std::size_t kHead = 128, kEntry = 12;
        const std::size_t start = kHead + 4 + kEntry * parts_.size();
        std::string table = number(parts_.size()), data;
        for (const auto& [name, part] : parts_) {
            table += name + number(start + data.size()) + number(part.size());
            data += part;
        }
        const std::string zeros(kHead, '\0');
        std::string head = number(start + data.size()) + zeros.substr(0, 4) + std::string("\4\x30\0\0", 4) +
                           "mntrRGB XYZ " + std::string("\7\xea\0\1\0\1\0\0\0\0\0\0", 12) + "acsp" +
                           zeros.substr(0, 28) + fixed("", {0.9642, 1.0, 0.8249});
        head.resize(kHead, '\0');
        return head + table + data;
    }

private:
    static std::string number(std::size_t value) {
        std::string bytes;
        for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
        return bytes;
    }
    // s15Fixed16 numbers behind the head of a type.
    static std::string fixed(const std::string& type, std::initializer_list<double> values) {
        std::string bytes = type.empty() ? "" : type + number(0);
        for (const double value : values)
            bytes += number(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(value * 65536.0))));
        return bytes;
    }
    static std::string words(const std::string& text) {
        std::string wide;
        for (const char c : text) (wide += '\0') += c;
        return "mluc" + number(0) + number(1) + number(12) + "enUS" + number(wide.size()) + number(28) + wide;
    }
    void add(const char* name, std::string part) {
        part.resize((part.size() + 3) / 4 * 4, '\0');
        parts_.emplace_back(name, std::move(part));
    }
    std::vector<std::pair<std::string, std::string>> parts_;
};

struct TiffClose {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using OpenTiff = std::unique_ptr<TIFF, TiffClose>;

OpenTiff open_tiff(TiffBytes& file) {
    TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
    if (options == nullptr) throw std::bad_alloc();
    TIFFOpenOptionsSetErrorHandlerExtR(options, on_tiff_error, &file);
    TIFFOpenOptionsSetWarningHandlerExtR(options, on_tiff_error, &file);
    TIFF* tiff = TIFFClientOpenExt(
        "picture", "wl", &file, read_bytes, write_bytes, seek_bytes, [](thandle_t) { return 0; },
        [](thandle_t handle) { return toff_t{static_cast<TiffBytes*>(handle)->bytes.size()}; }, nullptr, nullptr,
        options);
    TIFFOpenOptionsFree(options);
    return OpenTiff(tiff);
}

void describe(TIFF* tiff, const DisplayedPicture& picture) {
    const Image<unsigned short>& image = picture.words;
    constexpr std::size_t kStrip = 1u << 18;  // bytes
    const std::size_t row = static_cast<std::size_t>(image.width) * 3 * sizeof(unsigned short);
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(image.width));
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(image.height));
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 16);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 3);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
    TIFFSetField(tiff, TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, static_cast<std::uint32_t>(std::max(kStrip / row, std::size_t{1})));
    Texts said = picture.texts;
    const auto xmp = said.extract(kXmpWord);
    const std::string profile = SrgbProfile().bytes(), texts = fmt::format("{}", fmt::join(history_cards(said), "\n"));
    TIFFSetField(tiff, TIFFTAG_ICCPROFILE, static_cast<std::uint32_t>(profile.size()), profile.data());
    TIFFSetField(tiff, TIFFTAG_SOFTWARE, picture.software.c_str());
    if (!picture.title.empty()) TIFFSetField(tiff, TIFFTAG_DOCUMENTNAME, picture.title.c_str());
    if (!texts.empty()) TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, texts.c_str());
    if (!xmp.empty())
        TIFFSetField(tiff, TIFFTAG_XMLPACKET, static_cast<std::uint32_t>(xmp.mapped().size()), xmp.mapped().data());
}

Status save_tiff(const std::filesystem::path& path, const DisplayedPicture& picture) {
    const auto invalid = [&](const std::string& why) {
        return failed(fmt::format("cannot write '{}': {}", path.string(), why));
    };
    const Image<unsigned short>& image = picture.words;
    const std::size_t values =
        static_cast<std::size_t>(std::max(image.width, 0)) * static_cast<std::size_t>(std::max(image.height, 0)) * 3;
    if (values == 0 || image.channels != 3 || image.data.size() != values)
        return invalid(
            fmt::format("{} x {} pixels of {} channels are no TIFF image", image.width, image.height, image.channels));
    TiffBytes file;
    OpenTiff tiff = open_tiff(file);
    if (tiff == nullptr) return invalid("libtiff: " + file.fault);
    describe(tiff.get(), picture);
    std::vector<unsigned short> row;  // the predictor changes it
    for (int y = 0; y < image.height && file.fault.empty(); ++y) {
        row.assign(image.at(0, y), image.at(0, y) + 3 * image.width);
        TIFFWriteScanline(tiff.get(), row.data(), static_cast<std::uint32_t>(y), 0);
    }
    tiff.reset();  // writes the directory
    if (!file.fault.empty()) return invalid("libtiff: " + file.fault);
    return write_text_atomically(path, file.bytes);
}

// Numbers of a file that says which byte comes first.
std::size_t tiff_number(std::string bytes, bool little) {
    if (little) std::ranges::reverse(bytes);
    return big_endian(bytes);
}

// The ImageDescription of the first directory.
Result<Texts> tiff_texts_of(std::istream& file) {
    constexpr std::size_t kDescription = 270, kEntry = 12, kInPlace = 4;
    const auto head = bytes_from(file, 8);
    if (!head) return texts_cut_off();
    const bool little = head->starts_with("II");
    file.seekg(static_cast<std::streamoff>(tiff_number(head->substr(4), little)));
    const auto entries = bytes_from(file, 2);
    if (!entries) return texts_cut_off();
    for (std::size_t left = tiff_number(*entries, little); left > 0; --left) {
        const auto entry = bytes_from(file, kEntry);
        if (!entry) return texts_cut_off();
        if (tiff_number(entry->substr(0, 2), little) != kDescription) continue;
        const std::size_t size = tiff_number(entry->substr(4, 4), little);
        if (size > kMostTextBytes) return texts_too_long();
        if (size > kInPlace) file.seekg(static_cast<std::streamoff>(tiff_number(entry->substr(8), little)));
        const auto text = size > kInPlace ? bytes_from(file, size) : entry->substr(8, size);
        if (!text) return texts_cut_off();
        return texts_of_cards(split(text->substr(0, text->find('\0')), '\n'));
    }
    return Texts();
}

}  // namespace

const PictureFormat kTiffFormat = {
    .name = "TIFF",
    .ending = ".tif",
    .other = ".tiff",
    .sample = Sample::kWord,
    .help = "16 bits, display-ready",
    .options = "--bits",
    .is =
        [](std::string_view bytes) {
            return bytes.starts_with({"II*\0", 4}) || bytes.starts_with({"MM\0*", 4});
        },
    .texts = tiff_texts_of,
    .save = save_tiff,
};

}  // namespace nullscope
