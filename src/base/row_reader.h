// PNG and JPEG files row by row, by libpng and libjpeg: for pictures too large to be held. Nothing is kept but a row; files whose
// kind needs more (interlaced PNG, progressive JPEG) are refused.
#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "base/result.h"

namespace nullscope {

// Writes up to `most` bytes of a file that is read from its beginning; fewer only at its end.
using ByteSource = std::function<std::size_t(char* to, std::size_t most)>;

class RowReader {
public:
    virtual ~RowReader() = default;
    int width = 0, height = 0, channels = 0;  // 3, or 4 with alpha
    // The next row, linear light; at most height times. Errors: damaged, too short.
    virtual Status next(float* row) = 0;
};

// Errors (without a file name): not such a file, a kind that cannot be read by rows.
Result<std::unique_ptr<RowReader>> open_png_rows(ByteSource source);
Result<std::unique_ptr<RowReader>> open_jpeg_rows(ByteSource source);

}  // namespace nullscope
