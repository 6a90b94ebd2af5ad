// The standard deviation of data in words: "0.02", or "3%" of the largest.
#pragma once
#include <optional>
#include <string>

#include "base/text.h"

namespace nullscope::fit {

// Nothing: they are no number. largest: of the data's magnitudes.
inline std::optional<double> sigma_of_words(const std::string& words, double largest) {
    const bool is_share = words.ends_with('%');
    const auto number = parse_number(is_share ? words.substr(0, words.size() - 1) : words);
    return number && is_share ? std::optional(0.01 * *number * largest) : number;
}

}  // namespace nullscope::fit
