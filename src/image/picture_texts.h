// What picture files say of themselves, by keyword ("nullscope.scene_text"), without their pixels being read. A format that limits the length of
// a text holds it in pieces, KEYWORD.0, KEYWORD.1, ..., which are put together again.
#pragma once
#include <filesystem>
#include <istream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace nullscope {

using Texts = std::map<std::string, std::string>;

inline constexpr std::string_view kOwnTexts = "nullscope.";  // how the keywords begin of what this program writes
inline constexpr std::size_t kMostTextBytes = 16u << 20;     // of all texts of a file

// By the first bytes: PNG, JPEG, EXR or FITS.
bool is_picture(std::string_view bytes);
bool is_picture_file(const std::filesystem::path& path);

// Texts that are longer than `most` bytes in pieces of at most so many, none of which ends within a character of UTF-8.
Texts in_pieces(const Texts& texts, std::size_t most);
// The inverse, of keywords that begin with kOwnTexts.
Texts put_together(Texts pieces);

// PNG: tEXt, zTXt and iTXt chunks anywhere in the file. JPEG: comments whose first line is such a keyword. EXR: string attributes of the first part.
// FITS: HISTORY cards of the primary header as history_cards() makes them. name: what errors call the file.
// Errors (bad input): no such file, cut off or damaged within the texts, more than kMostTextBytes.
Result<Texts> read_texts(std::istream& file, const std::string& name);
Result<Texts> load_texts(const std::filesystem::path& path);

// Texts as HISTORY cards of at most 72 characters: "nullscope.scene_text", then each line behind "| ", and what does not fit behind "+ ".
// Bytes that are no printable ASCII, "%", and a blank at an end are written as %20 is.
std::vector<std::string> history_cards(const Texts& texts);

// Of libpng and OpenEXR's layout, for picture_texts.cpp. chunks: whole chunks with their lengths and check sums. header: the file's
// beginning. Errors without a file name.
Result<Texts> png_chunk_texts(std::string_view chunks);
Result<Texts> exr_header_texts(std::string_view header);

}  // namespace nullscope
