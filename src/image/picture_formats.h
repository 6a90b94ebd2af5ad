// The formats of pictures that are written: what is said of each in one place, its row, in its own file (png_file.cpp). A format is added by
// its file and its lines here (CONTRIBUTING.md).
#pragma once
#include <array>
#include <filesystem>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "image/image.h"
#include "image/picture_texts.h"
#include "image/sample.h"

namespace nullscope {

// A displayed picture, by its format's Sample, and what its file says of itself.
struct DisplayedPicture {
    const Image<unsigned char>& bytes;
    const Image<unsigned short>& words;
    std::string title, software;
    std::optional<int> quality;  // of formats that have one
    const Texts& texts;
};

struct PictureFormat {
    std::string_view name;    // "JPEG"
    std::string_view ending;  // of files' names: ".jpg"
    std::string_view other;   // another ending; "": none
    Sample sample;
    std::string_view help;     // "display-ready"
    std::string_view options;  // of capture, by name, what only its files have: "--quality"
    // Whether these are a file's first bytes; what it says of itself, from its beginning on. Errors: as read_texts, without a name.
    bool (*is)(std::string_view bytes);
    Result<Texts> (*texts)(std::istream& file);
    // Under its name only when complete. null: what is written depends on the scene (save_exr, save_fits of image_file.h).
    Status (*save)(const std::filesystem::path& path, const DisplayedPicture& picture) = nullptr;
};

extern const PictureFormat kPngFormat;
extern const PictureFormat kJpegFormat;
extern const PictureFormat kExrFormat;
extern const PictureFormat kFitsFormat;
extern const PictureFormat kTiffFormat;
inline constexpr std::array kPictureFormats = {
    &kPngFormat,   //
    &kJpegFormat,  //
    &kExrFormat,   //
    &kFitsFormat,  //
    &kTiffFormat,  //
};

const PictureFormat* format_named(const std::filesystem::path& file);  // by its ending; nullptr: none of these
// ".png, .jpg, .exr or .fits", of all or those that a condition holds for; before: what stands before the last.
std::string format_endings(std::string_view before = " or ", bool (*of)(const PictureFormat&) = nullptr);

}  // namespace nullscope
