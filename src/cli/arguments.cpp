#include "cli/arguments.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "base/text.h"

namespace nullscope::cli {
namespace {

// The two whole numbers on either side of the separator, each in [least, most].
std::optional<std::pair<int, int>> two_numbers(const std::string& text, char separator, double least, double most) {
    const auto parts = split(text, separator);
    if (parts.size() != 2) return std::nullopt;
    const auto a = parse_number(parts[0]), b = parse_number(parts[1]);
    const auto good = [&](const std::optional<double>& n) {
        return n && *n >= least && *n <= most && *n == static_cast<int>(*n);
    };
    if (!good(a) || !good(b)) return std::nullopt;
    return std::pair(static_cast<int>(*a), static_cast<int>(*b));
}

}  // namespace

Result<Size> parse_size(const std::string& text) {
    if (const auto size = two_numbers(text, 'x', 1, 65536)) return Size{size->first, size->second};
    return bad_input(
        fmt::format("--size {}: not a size; allowed: WIDTHxHEIGHT, whole numbers from 1x1 to 65536x65536", text));
}

Result<Frames> parse_frames(const std::string& text) {
    const auto range = two_numbers(text, ':', 0, 1e8);
    if (range && range->first < range->second) return Frames{range->first, range->second};
    return bad_input(fmt::format("--frames {}: not a range; allowed: A:B, whole numbers with 0 <= A < B", text));
}

}  // namespace nullscope::cli
