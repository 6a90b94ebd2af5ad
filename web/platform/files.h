// Files of a page: those that it has put into memory (put_file), by their path. libc++ for wasm32 has paths and no files;
// here are the questions of std::filesystem that src/ asks. Included before every file (web/CMakeLists.txt).
#pragma once
#ifdef __cplusplus
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <system_error>
#include <vector>

namespace nullscope::web {

using Files = std::map<std::string, std::string, std::less<>>;  // content by path
Files& files();
// Paths that were asked for and not there: what the page may fetch.
std::set<std::string>& missed();
// Its content, or nullptr; a path with dots is that without.
const std::string* find_file(const std::filesystem::path& path);

}  // namespace nullscope::web

namespace std::filesystem {

file_status status(const path& p, std::error_code& error);
inline bool exists(file_status s) { return s.type() != file_type::not_found; }
inline bool is_regular_file(file_status s) { return s.type() == file_type::regular; }
inline bool is_directory(file_status s) { return s.type() == file_type::directory; }
inline bool exists(const path& p, std::error_code& error) { return exists(status(p, error)); }
inline bool is_regular_file(const path& p, std::error_code& error) { return is_regular_file(status(p, error)); }
inline bool is_directory(const path& p, std::error_code& error) { return is_directory(status(p, error)); }
inline std::uintmax_t file_size(const path& p, std::error_code& error) {
    const std::string* content = nullscope::web::find_file(p);
    error = content == nullptr ? std::make_error_code(std::errc::no_such_file_or_directory) : std::error_code();
    return content == nullptr ? 0 : content->size();
}
inline file_time_type last_write_time(const path&, std::error_code& error) { return error.clear(), file_time_type(); }
inline path absolute(const path& p) { return p.is_absolute() ? p : "/" / p; }
inline path absolute(const path& p, std::error_code& error) { return error.clear(), absolute(p); }
inline path weakly_canonical(const path& p, std::error_code& error) {
    return error.clear(), absolute(p).lexically_normal();
}

class directory_entry {
public:
    explicit directory_entry(filesystem::path path) : path_(std::move(path)) {}
    const filesystem::path& path() const { return path_; }

private:
    filesystem::path path_;
};

// Files of a folder, not its folders.
class directory_iterator {
public:
    directory_iterator() = default;
    directory_iterator(const path& folder, std::error_code& error) {
        error.clear();
        for (const auto& [name, content] : nullscope::web::files())
            if (path(name).parent_path() == folder) entries_.emplace_back(name);
    }
    const directory_entry* operator->() const { return &entries_[at_]; }
    directory_iterator& increment(std::error_code&) { return ++at_, *this; }
    friend bool operator==(const directory_iterator& a, const directory_iterator& b) {
        return a.entries_.size() - a.at_ == b.entries_.size() - b.at_;
    }

private:
    std::vector<directory_entry> entries_;
    std::size_t at_ = 0;
};

}  // namespace std::filesystem
#endif
