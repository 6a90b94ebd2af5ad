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

inline constexpr std::string_view kOwnTexts = "nullscope.";   // how the keywords begin of what this program writes
inline constexpr const char* kXmpWord = "XML:com.adobe.xmp";  // an XMP packet, which PNG has by this keyword
inline constexpr std::size_t kMostTextBytes = 16u << 20;      // of all texts of a file

bool is_picture_file(  // by its first bytes, of one of the formats of picture_formats.h
    const std::filesystem::path& path);

// Texts that are longer than `most` bytes in pieces of at most so many, none of which ends within a character of UTF-8.
Texts in_pieces(const Texts& texts, std::size_t most);
// The inverse, of keywords that begin with kOwnTexts.
Texts put_together(Texts pieces);

// By PictureFormat::texts. name: what errors call the file.
// Errors (bad input): no such file, cut off or damaged within the texts, more than kMostTextBytes.
Result<Texts> read_texts(std::istream& file, const std::string& name);
Result<Texts> load_texts(const std::filesystem::path& path);

// Texts as cards (of FITS: HISTORY) of at most 72 characters: "nullscope.scene_text", then each line behind "| ", and what does not fit behind "+ ".
// Bytes that are no printable ASCII, "%", and a blank at an end are written as %20 is.
std::vector<std::string> history_cards(const Texts& texts);
Texts texts_of_cards(const std::vector<std::string>& cards);  // its inverse; other cards are left alone

}  // namespace nullscope
