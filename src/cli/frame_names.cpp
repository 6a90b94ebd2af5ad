#include <fmt/format.h>

#include <filesystem>

#include "cli/frame_store.h"

namespace nullscope::cli {

Result<FrameNames> FrameNames::parse(const std::string& pattern) {
    const auto files = NumberedFiles::parse(pattern);
    if (!files)
        return bad_input(
            fmt::format("-o {}: a sequence needs one placeholder for the frame number, in the file's name; "
                        "allowed: names with one of {} (up to {} digits)",
                        pattern, kNumberPlaces, kMostNumberDigits));
    return FrameNames(pattern, *files);
}

FrameNames FrameNames::in_folder(const std::string& folder) {
    return {folder + "/%05d.png", NumberedFiles(folder + "/", ".png", 5)};
}

std::string FrameNames::stamp_file() const {
    const std::string& before = files_.before();
    const bool bare = before.empty() || before.ends_with('/');  // "%05d.png": a dot in front would hide it
    return before + (bare ? "frames" : "") + files_.after() + ".stamp";
}

}  // namespace nullscope::cli
