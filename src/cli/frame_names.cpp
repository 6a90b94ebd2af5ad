#include "cli/frame_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace nullscope::cli {
namespace {

constexpr std::size_t kMostDigits = 9;

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

bool names_frames(const std::string& output) {
    const Place place = next_place(output, 0);
    return place.length > 0 && (output[place.at] == '%' || place.length > 1);
}

Result<FrameNames> FrameNames::parse(const std::string& pattern) {
    const Place place = next_place(pattern, 0);
    const bool single = place.length > 0 && next_place(pattern, place.at + place.length).length == 0 &&
                        pattern.find('/', place.at) == std::string::npos;
    if (!single || place.digits > kMostDigits)
        return bad_input(
            fmt::format("-o {}: a sequence needs one placeholder for the frame number, in the file's name; "
                        "allowed: names with one of %05d, %d or ##### (up to {} digits)",
                        pattern, kMostDigits));
    return FrameNames(pattern, pattern.substr(0, place.at), pattern.substr(place.at + place.length),
                      static_cast<int>(place.digits));
}

FrameNames FrameNames::in_folder(const std::string& folder) { return {folder + "/%05d.png", folder + "/", ".png", 5}; }

std::string FrameNames::stamp_file() const {
    const bool bare = before_.empty() || before_.ends_with('/');  // "%05d.png": a dot in front would hide it
    return before_ + (bare ? "frames" : "") + after_ + ".stamp";
}

std::string FrameNames::of(int frame) const { return fmt::format("{}{:0{}d}{}", before_, frame, digits_, after_); }

std::vector<int> FrameNames::on_disk() const {
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
        if (digits.size() > kMostDigits || digits.find_first_not_of("0123456789") != std::string::npos) continue;
        const int number = std::atoi(digits.c_str());
        if (fs::path(of(number)).filename() == name) numbers.push_back(number);
    }
    std::ranges::sort(numbers);
    return numbers;
}

}  // namespace nullscope::cli
