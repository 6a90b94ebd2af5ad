#include "base/assets.h"

#include <cstdlib>
#include <system_error>

#include "platform/places.h"

namespace nullscope {
namespace {

std::filesystem::path& shipped() {
    static std::filesystem::path directory;
    return directory;
}

}  // namespace

void ship_assets(const std::filesystem::path& directory) { shipped() = directory; }

std::filesystem::path assets_directory() {
    namespace fs = std::filesystem;
    if (const char* set = std::getenv("NULLSCOPE_ASSETS"); set && *set) return set;
    if (!shipped().empty()) return shipped();
    std::error_code error;
    if (const fs::path program = platform::program_file(); !program.empty())
        // Installed in bin, or unpacked with the programs on top.
        for (const fs::path& prefix : {program.parent_path().parent_path(), program.parent_path()})
            if (fs::path installed = prefix / "share" / "nullscope"; fs::is_directory(installed, error))
                return installed;
    return NULLSCOPE_SOURCE_ASSETS;
}

}  // namespace nullscope
