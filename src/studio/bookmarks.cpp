#include "studio/bookmarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

#include "base/atomic_file.h"
#include "base/text.h"
#include "image/image_file.h"
#include "scenefile/scene_edit.h"
#include "scenefile/scene_file.h"
#include "scenefile/scene_writer.h"

namespace nullscope::viewer {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = "bookmark-";
constexpr int kLargestNumber = 999'999;  // in six digits, so that names have the order of numbers

// Of files that the viewer named; else 0.
int number_of(const std::string& stem) {
    if (!stem.starts_with(kPrefix)) return 0;
    int number = 0;
    const char* end = stem.data() + stem.size();
    const auto read = std::from_chars(stem.data() + kPrefix.size(), end, number);
    return read.ec == std::errc() && read.ptr == end ? std::clamp(number, 0, kLargestNumber) : 0;
}

// A scene's name without the number that its bookmark gave it.
std::string title_of(const Scene& scene, const fs::path& source, const fs::path& folder) {
    const std::string number = fmt::format(" {}", number_of(source.stem().string()));
    const bool numbered = source.parent_path() == folder && scene.name.ends_with(number);
    return numbered ? scene.name.substr(0, scene.name.size() - number.size()) : scene.name;
}

// Cut between characters of UTF-8.
std::string shortened(std::string text, std::size_t most) {
    if (text.size() <= most) return text;
    while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xc0u) == 0x80u) --most;
    text.resize(most);
    return text;
}

Status write_scene(Scene scene, const std::string& name, const fs::path& file) {
    scene.name = name;
    TRY(checked, savable(scene));
    return write_text_atomically(file, scene_file_text(*checked, file.parent_path()));
}

Status remove_file(const fs::path& file) {
    std::error_code error;
    fs::remove(file, error);
    return error ? Status(failed(fmt::format("{}: {}", without_controls(file.string()), error.message()))) : Done{};
}

}  // namespace

void Bookmarks::list() {
    std::vector<Bookmark> known = std::exchange(all_, {});
    std::error_code error;
    for (fs::directory_iterator i(folder_, error), end; !error && i != end; i.increment(error)) {
        const std::string stem = i->path().stem().string();
        std::error_code unknown;
        if (i->path().extension() != ".toml" || stem.starts_with('.') || !i->is_regular_file(unknown)) continue;
        last_number_ = std::max(last_number_, number_of(stem));
        const auto found = std::ranges::find(known, stem, &Bookmark::stem);
        all_.push_back(found != known.end() ? std::move(*found) : Bookmark{stem, "", ""});
    }
    std::ranges::sort(all_, std::ranges::greater(), &Bookmark::stem);
    if (all_.size() > kMost) all_.resize(kMost);
}

bool Bookmarks::read(const std::string& stem) {
    const auto found = std::ranges::find(all_, stem, &Bookmark::stem);
    if (found == all_.end() || !found->name.empty() || !found->error.empty()) return false;
    const auto scene = load_scene(scene_file(stem).string());
    if (scene)
        found->name = scene->name.empty() ? stem : scene->name;
    else
        found->error = scene.error().message();
    return true;
}

Result<std::string> Bookmarks::add(const Scene& scene, const std::string& source, const Image<unsigned char>& picture) {
    if (folder_.empty()) return failed("no bookmark without a home folder: neither XDG_STATE_HOME nor HOME is set");
    list();
    if (all_.size() >= kMost) return failed(fmt::format("{} bookmarks are kept at most: delete one first", kMost));
    const int number = last_number_ + 1;
    if (number > kLargestNumber) return failed("bookmark-999999 is the last: rename or delete its file");
    std::error_code error;
    fs::create_directories(folder_, error);  // if it fails, writing says so
    const std::string stem = fmt::format("{}{:06}", kPrefix, number);
    const std::string title = without_controls(title_of(scene, source, folder_));
    const std::string ending = fmt::format(" {}", number);
    const std::string name = shortened(title, kLongestName - ending.size()) + ending;
    if (!picture.empty()) {
        TRY(drawn, save_jpeg(picture_file(stem), picture));
    }
    if (Status written = write_scene(scene, name, scene_file(stem)); !written) {
        fs::remove(picture_file(stem), error);
        return written.error();
    }
    last_number_ = number;
    all_.insert(all_.begin(), {stem, name, ""});
    return name;
}

Status Bookmarks::rename(const std::string& stem, const std::string& name) {
    const std::string wanted = trim(name);
    if (wanted.empty() || wanted.size() > kLongestName || wanted != without_controls(wanted))
        return bad_input("no such name of a bookmark", fmt::format("1 to {} bytes of text", kLongestName));
    TRY(scene, load_scene(scene_file(stem).string()));
    TRY(written, write_scene(*scene, wanted, scene_file(stem)));
    const auto found = std::ranges::find(all_, stem, &Bookmark::stem);
    if (found != all_.end()) found->name = wanted;
    return Done{};
}

Status Bookmarks::remove(const std::string& stem) {
    const auto found = std::ranges::find(all_, stem, &Bookmark::stem);
    if (found == all_.end()) return Done{};
    TRY(scene, read_text(scene_file(stem), kLargestSceneFile));
    std::error_code error;
    std::string picture;
    if (fs::is_regular_file(picture_file(stem), error)) {
        TRY(bytes, read_text(picture_file(stem)));
        picture = std::move(*bytes);
    }
    TRY(gone, remove_file(scene_file(stem)));
    if (!picture.empty()) fs::remove(picture_file(stem), error);  // a picture alone is no bookmark
    removed_.push_back({*found, std::move(*scene), std::move(picture)});
    all_.erase(found);
    return Done{};
}

Status Bookmarks::restore() {
    if (removed_.empty()) return Done{};
    const Removed& last = removed_.back();
    std::error_code error;
    fs::create_directories(folder_, error);
    if (!last.picture.empty()) {
        TRY(drawn, write_text_atomically(picture_file(last.bookmark.stem), last.picture));
    }
    TRY(written, write_text_atomically(scene_file(last.bookmark.stem), last.scene));
    removed_.pop_back();
    list();
    return Done{};
}

}  // namespace nullscope::viewer
