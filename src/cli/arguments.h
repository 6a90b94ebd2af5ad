// Words of the command line that several subcommands, or the fuzz targets, read.
#pragma once
#include <string>

#include "base/result.h"

namespace nullscope::cli {

struct Size {
    int width, height;
};
// "1280x720"; each side 1 ... 65536.
Result<Size> parse_size(const std::string& text);

// "A:B", the half-open range of frame numbers; 0 <= A < B.
struct Frames {
    int first = 0, end = 1;
};
Result<Frames> parse_frames(const std::string& text);

}  // namespace nullscope::cli
