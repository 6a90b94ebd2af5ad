#include "base/numbered_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace nullscope {
namespace {

// A place for a number: where it begins, how long it is, how many digits it asks for. length 0: there is none.
struct Place {
    std::size_t at = 0, length = 0, digits = 0;
};

Place next_place(const std::string& text, std::size_t from) {
    for (std::size_t at = text.find_first_of("#%", from); at < text.size(); at = text.find_first_of("#%", at + 1)) {
        const bool hashes = text[at] == '#';
        const std::size_t end = std::min(text.find_first_not_of(hashes ? "#" : "0123456789", at + 1), text.size());
        if (hashes) return {at, end - at, end - at};
        if (end == text.size() || text[end] != 'd') continue;
        return {at, end + 1 - at, std::max(std::strtoul(text.c_str() + at + 1, nullptr, 10), 1ul)};
    }
    return {};
}

}  // namespace

bool names_numbers(const std::string& text) {
    const Place place = next_place(text, 0);
    return place.length > 0 && (text[place.at] == '%' || place.length > 1);
}

std::optional<NumberedFiles> NumberedFiles::parse(const std::string& pattern, const std::string& folder) {
    const Place place = next_place(pattern, 0);
    const bool single = place.length > 0 && next_place(pattern, place.at + place.length).length == 0 &&
                        pattern.find('/', place.at) == std::string::npos;
    if (!single || place.digits > static_cast<std::size_t>(kMostNumberDigits)) return std::nullopt;
    return NumberedFiles((folder.empty() ? "" : folder + '/') + pattern.substr(0, place.at),
                         pattern.substr(place.at + place.length), static_cast<int>(place.digits));
}

std::string NumberedFiles::of(int number) const { return fmt::format("{}{:0{}d}{}", before_, number, digits_, after_); }

std::vector<int> NumberedFiles::on_disk() const {
    namespace fs = std::filesystem;
    const fs::path folder = fs::path(before_).parent_path();
    const std::string begin = fs::path(before_).filename().string();
    std::vector<int> numbers;
    std::error_code error;
    for (fs::directory_iterator i(folder.empty() ? "." : folder, error), end; !error && i != end; i.increment(error)) {
        const std::string name = i->path().filename().string();
        if (name.size() <= begin.size() + after_.size() || !name.starts_with(begin) || !name.ends_with(after_))
            continue;
        const std::string digits = name.substr(begin.size(), name.size() - begin.size() - after_.size());
        if (digits.size() > static_cast<std::size_t>(kMostNumberDigits) ||
            digits.find_first_not_of("0123456789") != std::string::npos)
            continue;
        const int number = std::atoi(digits.c_str());
        if (fs::path(of(number)).filename() == name) numbers.push_back(number);
    }
    std::ranges::sort(numbers);
    return numbers;
}

}  // namespace nullscope
