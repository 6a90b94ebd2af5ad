#include "cli/frame_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace nullscope::cli {
namespace {

constexpr std::size_t kMostDigits = 9;

// A place for a number: where it begins, how long it is, how many digits it asks for. length 0: there is none.
struct Place {
    std::size_t at = 0, length = 0, digits = 0;
};

Place next_place(const std::string& text, std::size_t from) {
    for (std::size_t at = from; at < text.size(); ++at) {
        if (text[at] == '#') {
            const std::size_t end = std::min(text.find_first_not_of('#', at), text.size());
            return {at, end - at, end - at};
        }
        if (text[at] != '%') continue;
        std::size_t end = at + 1, digits = 0;
        for (; end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) && digits <= kMostDigits; ++end)
            digits = 10 * digits + static_cast<std::size_t>(text[end] - '0');
        if (end < text.size() && text[end] == 'd') return {at, end + 1 - at, std::max<std::size_t>(digits, 1)};
    }
    return {};
}

}  // namespace

Result<FrameNames> FrameNames::parse(const std::string& pattern) {
    const Place place = next_place(pattern, 0);
    const bool single = place.length > 0 && next_place(pattern, place.at + place.length).length == 0;
    if (!single || place.digits > kMostDigits)
        return bad_input(
            fmt::format("-o {}: a sequence needs one place for the frame's number; "
                        "allowed: names with one of %05d, %d or ##### (up to {} digits)",
                        pattern, kMostDigits));
    FrameNames names;
    names.pattern_ = pattern;
    names.before_ = pattern.substr(0, place.at);
    names.after_ = pattern.substr(place.at + place.length);
    names.digits_ = static_cast<int>(place.digits);
    return names;
}

FrameNames FrameNames::in_folder(const std::string& folder) {
    FrameNames names;
    names.pattern_ = folder + "/%05d.png";
    names.before_ = folder + "/";
    names.after_ = ".png";
    names.digits_ = 5;
    return names;
}

std::string FrameNames::stamp_file() const {
    const bool bare = before_.empty() || before_.ends_with('/');  // "%05d.png": a dot in front would hide it
    return before_ + (bare ? "frames" : "") + after_ + ".stamp";
}

std::string FrameNames::of(int frame) const { return fmt::format("{}{:0{}d}{}", before_, frame, digits_, after_); }

}  // namespace nullscope::cli
