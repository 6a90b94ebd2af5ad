// Small text helpers: the nearest known word for error messages, others' words made safe, numbers that parse as a whole.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nullscope {

// The candidate with the smallest edit distance to word; empty if none is closer than half of the word's length + 1.
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

// The whole of text as a number, surrounding blanks allowed; nothing otherwise ("1.5x" is not a number).
std::optional<double> parse_number(std::string_view text);

// Control characters (C0, DEL, and C1 as UTF-8) become '?': a message is one line and moves no cursor.
std::string without_controls(std::string text);

std::vector<std::string> split(std::string_view text, char separator);
std::string trim(std::string_view text);

}  // namespace nullscope
