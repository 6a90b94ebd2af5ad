// A film from numbered pictures, by the ffmpeg program where that is installed.
#pragma once
#include <string>

#include "base/result.h"

namespace nullscope::cli {

bool have_ffmpeg();
// folder/00000.png ... to an H.264 film; under its name only when complete. Errors: ffmpeg is missing or fails.
Status encode_film(const std::string& folder, int first, double rate, const std::string& output);

}  // namespace nullscope::cli
