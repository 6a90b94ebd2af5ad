// A film from numbered pictures, by the ffmpeg program where that is installed.
#pragma once
#include <string>

#include "base/result.h"

namespace nullscope::cli {

bool have_ffmpeg();
// The `count` pictures folder/00000.png ... from number `first` on to an H.264 film; under its name only when complete. Errors: ffmpeg is missing or fails.
Status encode_film(const std::string& folder, int first, int count, double rate, const std::string& output);

}  // namespace nullscope::cli
