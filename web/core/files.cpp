// Files that the page puts into memory.
#include "platform/files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/exports.h"

namespace nullscope::web {

NULLSCOPE_EXPORT(put_file)
void put_file(const char* path, std::size_t path_size, const char* content, std::size_t size) {
    files()[std::string(path, path_size)] = std::string(content, size);
}
// Its content as the answer; false: there is no such file.
NULLSCOPE_EXPORT(read_file) bool read_file(const char* path, std::size_t size) {
    const auto found = files().find(std::string_view(path, size));
    return found != files().end() && answer(found->second);
}
// [path, ...] of files that were asked for and not there, since the last call.
NULLSCOPE_EXPORT(missed_files) bool missed_files() {
    std::vector<std::string> paths;
    for (const std::string& path : missed()) paths.push_back(in_json(path));
    missed().clear();
    return answer(fmt::format("[{}]", fmt::join(paths, ", ")));
}

}  // namespace nullscope::web
