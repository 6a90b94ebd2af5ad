// The formats of image files, for large_image.cpp and image_file.cpp; OpenEXR's is in image_file.h. Errors are without a
// file name.
#pragma once
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"
#include "image/image.h"

namespace nullscope {

// What load_image and load_exr say of a file.
Error unreadable(const std::string& name, std::string_view reason);

// Writes up to `most` bytes of a file that is read from its beginning; fewer only at its end.
using ByteSource = std::function<std::size_t(char* to, std::size_t most)>;

// PNG and JPEG row by row, by libpng and libjpeg. Of most files nothing is kept but a row; interlaced PNG and
// progressive JPEG are held whole from their first row on.
class RowReader {
public:
    virtual ~RowReader() = default;
    int width = 0, height = 0, channels = 0;  // 3, or 4 with alpha
    const char* whole = nullptr;  // of a file that is held whole: what is said where it is too large for that
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

// 3 channels of 8 bits, 1 to 65500 px a side. Errors: as libjpeg says.
Result<std::string> encode_jpeg(const Image<unsigned char>& image, const std::string& comment, int quality);

// Radiance RGBE (.hdr).
bool is_hdr(std::string_view bytes);

// bytes: a whole file. Linear RGB. Errors: cut off, damaged, another orientation or colour
// format, larger than max_pixels.
Result<Image<float>> decode_hdr(std::string_view bytes, long long max_pixels);

}  // namespace nullscope
