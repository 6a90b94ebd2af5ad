#include "image/picture_formats.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace nullscope {

const PictureFormat* format_named(const std::filesystem::path& file) {
    const std::string name = file.string();
    const auto found = std::ranges::find_if(kPictureFormats, [&](const PictureFormat* format) {
        return name.ends_with(format->ending) || (!format->other.empty() && name.ends_with(format->other));
    });
    return found != kPictureFormats.end() ? *found : nullptr;
}

std::string format_endings(std::string_view before, bool (*of)(const PictureFormat&)) {
    std::vector<std::string_view> endings;
    for (const PictureFormat* format : kPictureFormats)
        if (of == nullptr || of(*format)) endings.push_back(format->ending);
    const std::string_view last = endings.back();
    endings.pop_back();
    if (endings.empty()) return std::string(last);
    return fmt::format("{}{}{}", fmt::join(endings, ", "), before, last);
}

}  // namespace nullscope
