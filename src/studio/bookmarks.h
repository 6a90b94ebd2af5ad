// Bookmarks: scenes kept with their view and a small picture, as files STEM.toml (a scene file) and STEM.jpg in one folder. No OpenGL.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "image/image.h"
#include "scene/scene.h"

namespace nullscope::viewer {

struct Bookmark {
    std::string stem;   // of its files' names
    std::string name;   // the scene's; "" until it was read
    std::string error;  // why it cannot be read, or nothing
};

class Bookmarks {
public:
    static constexpr std::size_t kMost = 200;
    static constexpr std::size_t kLongestName = 80;  // bytes

    // folder: created when there is something to keep; empty: there is no home, and nothing can be kept.
    explicit Bookmarks(std::filesystem::path folder) : folder_(std::move(folder)) {}

    // Looks which files there are, the last kMost by name. Cost: reads the folder, no file in it.
    void list();
    const std::vector<Bookmark>& all() const { return all_; }  // the newest first
    // Reads the scene of a bookmark that was not read yet, for its name. False if it was. Cost: 1 ms.
    bool read(const std::string& stem);

    // Keeps a scene. It is named after the scene, with a number that no other has; `source`, from where the scene came, may be a bookmark
    // itself, whose number is not kept. picture: 3 channels of 8 bits; none: the bookmark has no picture. Returns the bookmark's name.
    // Errors: kMost are kept already, no such scene can be saved, a file cannot be written; then nothing is kept.
    Result<std::string> add(const Scene& scene, const std::string& source, const Image<unsigned char>& picture);
    // name: 1 to kLongestName bytes without control characters; blanks around it are dropped. Errors: another name, the file cannot be
    // read or written.
    Status rename(const std::string& stem, const std::string& name);
    // Removes the files; they stay in memory for restore(). Errors: they cannot be read or removed.
    Status remove(const std::string& stem);
    std::string last_removed() const { return removed_.empty() ? "" : removed_.back().bookmark.name; }
    Status
    restore();  // the last that was removed, if there is one. Errors: it cannot be written, and is kept in memory

    std::filesystem::path scene_file(const std::string& stem) const { return folder_ / (stem + ".toml"); }
    std::filesystem::path picture_file(const std::string& stem) const { return folder_ / (stem + ".jpg"); }

private:
    struct Removed {
        Bookmark bookmark;
        std::string scene, picture;  // the files' bytes
    };
    std::filesystem::path folder_;
    std::vector<Bookmark> all_;
    std::vector<Removed> removed_;
    int last_number_ = 0;  // of a file that is there or was removed
};

}  // namespace nullscope::viewer
