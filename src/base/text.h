// Small text helpers: the nearest known word for error messages, others' words made safe, numbers that parse as a whole.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace nullscope {

// The candidate with the smallest edit distance to word; empty if none is closer than half of the word's length + 1.
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

// The whole of text as a number, surrounding blanks allowed; nothing otherwise ("1.5x" is not a number).
std::optional<double> parse_number(std::string_view text);
// The whole numbers on either side of the separator ("1280x720"), each in [least, most]; nothing for any other text.
std::optional<std::pair<int, int>> two_whole_numbers(std::string_view text, char separator, double least, double most);

// Control characters (C0, DEL, and C1 as UTF-8) become '?': a message is one line and moves no cursor.
std::string without_controls(std::string text);

// A file's own words in quotes, cut at 60 bytes (at a character's boundary).
std::string in_quotes(std::string_view text);

// FNV-1a, 64 bits. start: the hash of what stands before; another start makes another hash.
inline std::uint64_t fnv1a(std::string_view bytes, std::uint64_t start = 0xcbf29ce484222325u) {
    for (const char c : bytes) start = (start ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return start;
}

inline std::uint64_t little_endian(std::string_view bytes) {
    std::uint64_t value = 0;
    for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return value;
}

std::vector<std::string> split(std::string_view text, char separator);
// "1 parameter", "2 parameters"; many: where it is not `one` with an s.
std::string counted(long long count, std::string_view one, std::string_view many = {});
std::string lower_case(std::string text);  // of ASCII letters
std::string trim(std::string_view text);

}  // namespace nullscope
