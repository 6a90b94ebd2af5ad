#include <fmt/format.h>

#include "base/assets.h"
#include "base/atomic_file.h"
#include "base/file_part.h"
#include "platform/files.h"

namespace nullscope {

web::Files& web::files() {
    static Files all;
    return all;
}

std::set<std::string>& web::missed() {
    static std::set<std::string> paths;
    return paths;
}

const std::string* web::find_file(const std::filesystem::path& path) {
    const std::string name = path.lexically_normal().string();
    const auto found = files().find(name);
    if (found != files().end()) return &found->second;
    missed().insert(name);
    return nullptr;
}

std::filesystem::path assets_directory() { return "/assets"; }

Result<std::string> read_text(const std::filesystem::path& path, std::size_t max_bytes) {
    const std::string* content = web::find_file(path);
    if (content == nullptr) return bad_input(fmt::format("cannot read '{}': no such file", path.string()));
    if (content->size() > max_bytes)
        return bad_input(fmt::format("cannot read '{}': larger than {} bytes", path.string(), max_bytes));
    return *content;
}

std::string file_part(const std::filesystem::path& file, std::size_t bytes, FileEnd end) {
    const std::string* content = web::find_file(file);
    if (content == nullptr || content->size() <= bytes) return content == nullptr ? "" : *content;
    return end == FileEnd::kFirst ? content->substr(0, bytes) : content->substr(content->size() - bytes);
}

}  // namespace nullscope

namespace std::filesystem {

file_status status(const path& p, std::error_code& error) {
    error.clear();
    if (nullscope::web::find_file(p) != nullptr) return file_status(file_type::regular);
    const auto& all = nullscope::web::files();
    const std::string folder = p.lexically_normal().string() + "/";
    const auto next = all.lower_bound(folder);
    const bool there = next != all.end() && next->first.starts_with(folder);
    return file_status(there ? file_type::directory : file_type::not_found);
}

}  // namespace std::filesystem
