#include "base/text.h"

#include <fmt/format.h>

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nullscope {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";

// Levenshtein distance, one row at a time.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t above = row[j + 1];
            row[j + 1] = std::min({above + 1, row[j] + 1, diagonal + (a[i] == b[j] ? 0u : 1u)});
            diagonal = above;
        }
    }
    return row[b.size()];
}

bool is_control(std::string_view text, std::size_t i) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
    return byte(i) < 0x20 || byte(i) == 0x7F || (byte(i) == 0xC2 && i + 1 < text.size() && byte(i + 1) < 0xA0);
}

constexpr std::size_t kLongestQuote = 60;  // bytes

}  // namespace

std::string in_quotes(std::string_view text) {
    if (text.size() <= kLongestQuote) return fmt::format("\"{}\"", text);
    std::size_t end = kLongestQuote;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
    return fmt::format("\"{}...\"", text.substr(0, end));
}

std::string without_controls(std::string text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (!is_control(text, i)) continue;
        if (static_cast<unsigned char>(text[i]) == 0xC2) text[i + 1] = '?';
        text[i] = '?';
    }
    return text;
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
    std::size_t best_distance = word.size() / 2 + 1;
    std::string best;
    for (const std::string& candidate : candidates) {
        const std::size_t longer = std::max(word.size(), candidate.size());
        const std::size_t shorter = std::min(word.size(), candidate.size());
        if (longer - shorter >= best_distance) continue;  // the distance is at least that
        const std::size_t distance = edit_distance(word, candidate);
        if (distance >= best_distance) continue;
        best_distance = distance;
        best = candidate;
    }
    return best;
}

std::optional<double> parse_number(std::string_view text) {
    const std::string trimmed = trim(text);
    const char* begin = trimmed.data();
    const char* const end = begin + trimmed.size();
    if (begin != end && *begin == '+' && begin + 1 != end && begin[1] != '-') ++begin;  // from_chars knows no plus
    double value = 0.0;
    const auto [stop, error] = fast_float::from_chars(begin, end, value);
    if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<std::pair<int, int>> two_whole_numbers(std::string_view text, char separator, double least, double most) {
    const auto parts = split(text, separator);
    if (parts.size() != 2) return std::nullopt;
    const auto a = parse_number(parts[0]), b = parse_number(parts[1]);
    const auto good = [&](const std::optional<double>& n) {
        return n && *n >= least && *n <= most && *n == static_cast<int>(*n);
    };
    if (!good(a) || !good(b)) return std::nullopt;
    return std::pair(static_cast<int>(*a), static_cast<int>(*b));
}

std::string lower_case(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts;
    while (true) {
        const std::size_t at = text.find(separator);
        parts.emplace_back(text.substr(0, at));
        if (at == std::string_view::npos) return parts;
        text.remove_prefix(at + 1);
    }
}

std::string counted(long long count, std::string_view one, std::string_view many) {
    if (count == 1) return fmt::format("1 {}", one);
    return many.empty() ? fmt::format("{} {}s", count, one) : fmt::format("{} {}", count, many);
}

std::string trim(std::string_view text) {
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(kBlanks) - first + 1));
}

}  // namespace nullscope
