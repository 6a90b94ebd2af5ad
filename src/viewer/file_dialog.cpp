#include "viewer/file_dialog.h"

#include <filesystem>
#include <string>
#include <string_view>

#include "image/picture_formats.h"
#include "platform/places.h"

namespace nullscope::viewer {
namespace {

constexpr const char* kZenity = "zenity";
constexpr const char* kKdialog = "kdialog";

std::string patterns() {
    std::string all = "*.toml";
    for (const PictureFormat* format : kPictureFormats) all += " *" + std::string(format->ending);
    return all;
}

}  // namespace

bool FileDialog::available() {
    static const bool found = platform::is_in_path(kZenity) || platform::is_in_path(kKdialog);
    return found;
}

Status FileDialog::open() {
    if (platform::is_in_path(kZenity))
        return process_.start({kZenity, "--file-selection", "--title=Open a scene",
                               "--file-filter=Scenes, and pictures that hold one | " + patterns()});
    std::error_code error;
    return process_.start({kKdialog, "--getopenfilename", std::filesystem::current_path(error).string(),
                           "Scenes, and pictures that hold one (" + patterns() + ")"});
}

// Both print the path in a line, after warnings of their libraries; without a choice they end with a status of 1.
std::string FileDialog::poll() {
    const auto status = process_.poll();
    if (!status || *status != 0) return "";
    std::string said = process_.read();
    while (said.ends_with('\n')) said.pop_back();
    return said.substr(said.rfind('\n') + 1);
}

}  // namespace nullscope::viewer
