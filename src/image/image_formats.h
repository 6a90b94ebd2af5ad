// The formats of image files, for large_image.cpp and image_file.cpp. Errors are without a file name, but OpenEXR's.
#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <istream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "base/vec.h"
#include "image/image.h"

namespace nullscope {

// What load_image and load_exr say of a file.
Error unreadable(const std::string& name, std::string_view reason);

// For readers of texts: exactly so many bytes, nothing where the file ends before; what is said of files.
std::optional<std::string> bytes_from(std::istream& file, std::size_t count);
Error texts_cut_off();
Error texts_too_long();
inline std::size_t big_endian(std::string_view bytes) {
    std::size_t value = 0;
    for (const char c : bytes) value = value << 8 | static_cast<unsigned char>(c);
    return value;
}

// Writes up to `most` bytes of a file that is read from its beginning; fewer only at its end.
using ByteSource = std::function<std::size_t(char* to, std::size_t most)>;

// PNG and JPEG row by row, by libpng and libjpeg. Of most files nothing is kept but a row; interlaced PNG and
// progressive JPEG are held whole from their first row on.
class RowReader {
public:
    virtual ~RowReader() = default;
    int width = 0, height = 0, channels = 0;  // 3, or 4 with alpha
    const char* whole = nullptr;        // of a file that is held whole: what is said where it is too large for that
    int orientation = 1;                // orientation.h
    std::optional<Mat3> to_rec709;      // of its linear light; none: it is that of Rec. 709
    std::vector<std::string> unused{};  // what the file says and the reader leaves out, a few words each
    // The next row, linear light; at most height times, and the last only of a file that goes on to its end. Errors:
    // damaged, too short.
    virtual Status next(float* row) = 0;
};

// Read the header alone. Errors: not such a file, a kind that is not known.
Result<std::unique_ptr<RowReader>> open_png_rows(ByteSource source);
Result<std::unique_ptr<RowReader>> open_jpeg_rows(ByteSource source);

// 3 or 4 channels of 8 bits. Fast rather than dense: each pixel less the one before it, deflate's second level.
// Pictures of stars and discs of 1280 x 720 take 20 to 35 ms, a quarter of what stb needs, and a tenth to a fifth fewer
// bytes. Errors: as libpng says, no memory. texts: by keyword, UTF-8 (iTXt chunks before the pixels).
Result<std::string> encode_png(const Image<unsigned char>& image, const std::map<std::string, std::string>& texts = {});

inline constexpr std::size_t kMostMarkerBytes = 65533;  // of JPEG
inline constexpr std::string_view kXmpMark("http://ns.adobe.com/xap/1.0/\0",
                                           29);  // with which JPEG's marker of XMP begins

// The same of 16 bits a channel.
Result<std::string> encode_png(const Image<unsigned short>& image, const std::map<std::string, std::string>& texts);

// 3 channels of 8 bits, 1 to 65500 px a side. comments: of at most kMostMarkerBytes each. xmp: a packet; empty: none. Errors: as libjpeg
// says, a packet longer than a marker.
Result<std::string> encode_jpeg(const Image<unsigned char>& image, const std::vector<std::string>& comments,
                                int quality, const std::string& xmp = {});

// Of a file that is held whole.
struct WholePicture {
    Image<float> image;  // linear light
    int orientation = 1;
    std::optional<Mat3> to_rec709{};
    std::vector<std::string> unused{};
};
// Radiance RGBE (.hdr).
bool is_hdr(std::string_view bytes);
// bytes: a whole file. Errors: cut off, damaged, columns before rows, another colour format, larger than max_pixels.
Result<WholePicture> decode_hdr(std::string_view bytes, long long max_pixels);

// TGA, BMP and PSD (its merged picture); 3 channels, or 4 with alpha. TGA has no mark: what no other reader takes is one if its head is sound.
bool is_by_stb(std::string_view bytes);
// Errors: cut off, damaged, a kind that stb_image does not know, larger than max_pixels.
Result<WholePicture> decode_stb(std::string_view bytes, long long max_pixels);

// PGM and PPM as bytes (P5 and P6); 3 channels.
bool is_pnm(std::string_view bytes);
// bytes: is_pnm. Errors: cut off, damaged, larger than max_pixels.
Result<WholePicture> decode_pnm(std::string_view bytes, long long max_pixels);

// TIFF and BigTIFF, the first page; 3 channels, or 4 with alpha.
bool is_tiff(std::string_view bytes);
// Errors: cut off, damaged, a kind of numbers or colours that libtiff does not convert, larger than max_pixels.
Result<WholePicture> decode_tiff(std::string_view bytes, long long max_pixels);

// The one picture in an OpenEXR file: colours as they are stored, multiplied by alpha; 3 channels, or 4 if it has alpha that is wanted.
struct ExrPicture {
    Image<float> image;  // the display window
    bool has_alpha = false;
    std::optional<Mat3> to_rec709{};
    std::vector<std::string> unused{};
};
// wanted: a layer ("ViewLayer.Combined"), a part, or both ("part.layer"); empty: the file's own picture. Errors: as load_image; several
// pictures of which none is the file's, no such layer: with a list of what there is.
Result<ExrPicture> decode_exr_picture(std::string_view bytes, const std::string& name, long long max_pixels,
                                      bool with_alpha, const std::string& wanted = {});
Result<ExrPicture> load_exr_picture(const std::filesystem::path& path, long long max_pixels, bool with_alpha,
                                    const std::string& wanted = {});

// Whether an ICC profile calls itself sRGB.
inline bool is_srgb_profile(std::string_view profile) {
    constexpr std::string_view kWide("s\0R\0G\0B", 7);
    return profile.find("sRGB") != std::string_view::npos || profile.find(kWide) != std::string_view::npos;
}

}  // namespace nullscope
