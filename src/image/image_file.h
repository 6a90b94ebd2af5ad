// Image files. With large_image.h the only place that knows their packages.
//
// In memory: linear light, Rec. 709 primaries, float, top row first. 8-bit files are decoded from and encoded to sRGB.
// Every writer writes to a temporary name beside the target and renames: a file appears only when it is complete.
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/result.h"
#include "image/colour_space.h"
#include "image/image.h"

namespace nullscope {

// PNG, JPEG, HDR, TIFF, PNM, BMP, PSD and TGA by content, EXR by extension. channels: 3, or 4 with an alpha channel.
// Errors: no such file, not an image, damaged, larger than max_pixels (guards memory against hostile headers).
Result<Image<float>> load_image(const std::filesystem::path& path, long long max_pixels = 500'000'000);

// The same for a file in memory that is no EXR; name: what errors call it.
Result<Image<float>> decode_image(std::string_view bytes, const std::string& name, long long max_pixels = 500'000'000);

// 3 or 4 channels of 8 bits, already display-encoded. texts: what the file says of itself, by keyword ("Title", "Software").
Status save_png(const std::filesystem::path& path, const Image<unsigned char>& image,
                const std::map<std::string, std::string>& texts = {});
Status save_png16(const std::filesystem::path& path, const Image<unsigned short>& image,  // 16 bits a channel
                  const std::map<std::string, std::string>& texts = {});

// 3 channels of 8 bits, already display-encoded; colours at full resolution (4:4:4). quality: libjpeg's, 1 to 100; at 92 stars and
// thin rings keep their edges. comment: at most 65533 bytes. texts: what the file says of itself (image/picture_texts.h), as further comments.
inline constexpr int kJpegQuality = 92;
Status save_jpeg(const std::filesystem::path& path, const Image<unsigned char>& image, const std::string& comment = {},
                 int quality = kJpegQuality, const std::map<std::string, std::string>& texts = {});

// A set of named float channels of one size ("R", "G", "B", "sky.x", ...) and string attributes; ZIP-compressed, which
// every reader knows. A file has long attributes in pieces (image/picture_texts.h).
struct ChannelImage {
    int width = 0;
    int height = 0;
    std::map<std::string, std::vector<float>> channels;  // name -> width*height values, top row first
    std::map<std::string, std::string> attributes;
    std::optional<Primaries>
        primaries{};  // of its colours, written as chromaticities; none: Rec. 709, as OpenEXR has it
};
Status save_exr(const std::filesystem::path& path, const ChannelImage& image);

// The same of colours R, G and B that come in bands of rows, from the top: no more than a band of them is held. half: as half floats.
struct BandedImage {
    int width = 0, height = 0;
    bool half = false;  // what is beyond 65504, the largest half float, is written as that
    std::map<std::string, std::string> attributes;
    std::optional<Primaries> primaries{};  // as of ChannelImage
};
// rows_from(y): the rows from y on, at least one, 3 channels; errors of it are returned.
Status save_exr_bands(const std::filesystem::path& path, const BandedImage& image,
                      const std::function<Result<Image<float>>(int y)>& rows_from);
// Errors: as load_image.
Result<ChannelImage> load_exr(const std::filesystem::path& path, long long max_pixels = 500'000'000);
// The same for a file in memory; name: what errors call it.
Result<ChannelImage> decode_exr(std::string_view bytes, const std::string& name, long long max_pixels);

// What a FITS file (FITS Standard 4.0, Pence et al. 2010; written by CFITSIO) says before its numbers. Keywords: at most 8 of A-Z, 0-9, - and
// _. Text is written in ASCII, other characters as "?".
struct FitsCard {
    std::string keyword;
    std::variant<double, long long, std::string> value;
    std::string comment;
};
struct FitsHeader {
    std::string unit{};          // BUNIT: "Jy/pixel"; empty: a number without a unit
    std::string unit_comment{};  // what the numbers are
    std::vector<FitsCard> cards{};
    std::vector<std::string> comments{};         // lines of at most 72 characters
    std::map<std::string, std::string> texts{};  // what the file says of itself: HISTORY cards (image/picture_texts.h)
};
// Floats of 32 bits, bottom row first, as FITS has them. image: one channel, which is one plane, or the four Stokes parameters I, Q, U, V, as planes of
// an axis STOKES. colours: empty, or three channels of the same size, which are the extensions RED, GREEN and BLUE; these have the header's unit and
// cards too. Every part has DATASUM and CHECKSUM. The file has no date: the same picture is the same file. Holds it twice more in memory. Errors: other
// numbers of channels, other keywords, numbers that are not finite, what CFITSIO and the system say.
Status save_fits(const std::filesystem::path& path, const Image<float>& image, const FitsHeader& header,
                 const Image<float>& colours = {});

// Display encoding of one linear component (IEC 61966-2-1), clamped to [0, 1].
float srgb_from_linear(float linear);
float linear_from_srgb(float encoded);
// Of an image of 3 or 4 channels: RGBA of 8 bits, top row first.
std::vector<unsigned char> rgba8_of(const Image<float>& image);

}  // namespace nullscope
