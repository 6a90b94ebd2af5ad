// Pictures of FITS files (FITS Standard 4.0): the first part of a file, whoever wrote it.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "image/image.h"

namespace nullscope {

struct FitsPicture {
    Image<double> planes;                      // top row first: files have the bottom row first
    std::map<std::string, std::string> cards;  // keyword -> its value's text, without quotes and comment

    std::optional<double> number(const std::string& keyword) const;
    std::string text(const std::string& keyword) const;  // "" where there is none
};

inline constexpr std::size_t kLargestFits = std::size_t{1} << 30;  // bytes

// A picture of floats or doubles, one plane or four; axes beyond the third have length 1. BSCALE and BZERO are applied.
// Errors (bad input), with the card that is meant: no FITS file, cut off, other kinds and numbers of numbers, some of them not finite. name: what
// errors call the file.
Result<FitsPicture> parse_fits(std::string_view bytes, const std::string& name);
Result<FitsPicture> load_fits(const std::filesystem::path& path);

}  // namespace nullscope
