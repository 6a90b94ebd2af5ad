// What must hold of a JPEG file before stb_image may see it; used by image_file.cpp.
#pragma once
#include <string_view>

#include "base/result.h"

namespace nullscope {

// bytes: a whole file that begins like a JPEG. Errors (without a file name):
// - a Huffman table of more than 256 codes: stb_image up to 2.27 (Debian 12) writes beyond its end;
// - a scan whose Huffman table was not defined: it reads what was in memory, and by that outside of the table;
// - no end of the picture: stb_image since 2.28 (Debian 13) fills what is missing;
// - more than 256 scans: each costs as much time as the whole picture, and takes a dozen bytes to ask for. (An encoder
//   makes one a component, or about ten where the picture comes in progressively.)
Status check_jpeg(std::string_view bytes);

}  // namespace nullscope
