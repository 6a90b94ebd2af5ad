// The standard deviation of data in words: "0.02", or "3%" of the largest.
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>

#include "base/result.h"
#include "base/text.h"

namespace nullscope::fit {

// Nothing: they are no number. largest: of the data's magnitudes.
inline std::optional<double> sigma_of_words(const std::string& words, double largest) {
    const bool is_share = words.ends_with('%');
    const auto number = parse_number(is_share ? words.substr(0, words.size() - 1) : words);
    return number && is_share ? std::optional(0.01 * *number * largest) : number;
}

// Of data that share one. Errors (bad input): words that are no number above 0.
inline Result<double> shared_sigma(const std::string& words, double largest) {
    const auto sigma = sigma_of_words(words, largest);
    if (sigma && *sigma > 0 && std::isfinite(*sigma)) return *sigma;
    return bad_input(without_controls(fmt::format("--sigma {}", words)), "a number or a share in %, above 0");
}

}  // namespace nullscope::fit
