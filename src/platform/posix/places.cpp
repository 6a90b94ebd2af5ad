#include "platform/places.h"

#include <unistd.h>

#include <cstdlib>
#include <sstream>

namespace nullscope::platform {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const char* variable, const char* below_home) {
    if (const char* set = std::getenv(variable); set != nullptr && fs::path(set).is_absolute())
        return fs::path(set) / "nullscope";
    const char* home = std::getenv("HOME");
    return home != nullptr && *home != '\0' ? fs::path(home) / below_home / "nullscope" : fs::path();
}

}  // namespace

fs::path program_file() {
    std::error_code error;
    fs::path file = fs::read_symlink("/proc/self/exe", error);
    return error ? fs::path() : file;
}

std::string program_name(const std::string& name) { return name; }

fs::path settings_folder() { return folder_of("XDG_CONFIG_HOME", ".config"); }
fs::path state_folder() { return folder_of("XDG_STATE_HOME", ".local/state"); }

bool is_in_path(const std::string& program) {
    const char* path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): nobody sets it meanwhile
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (::access((fs::path(folder) / program).c_str(), X_OK) == 0) return true;
    return false;
}

}  // namespace nullscope::platform
