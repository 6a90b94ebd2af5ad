#include "platform/places.h"

#include <windows.h>

#include <array>
#include <cstdlib>

namespace nullscope::platform {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const wchar_t* variable) {
    const wchar_t* const set = _wgetenv(variable);
    return set != nullptr && *set != L'\0' ? fs::path(set) / "nullscope" : fs::path();
}

}  // namespace

fs::path program_file() {
    std::array<wchar_t, 32768> name;  // the longest path that there is
    const DWORD length = ::GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size()));
    return std::wstring(name.data(), length);
}

std::string program_name(const std::string& name) { return name + ".exe"; }

fs::path settings_folder() { return folder_of(L"APPDATA"); }
fs::path state_folder() { return folder_of(L"LOCALAPPDATA"); }

bool is_in_path(const std::string& program) {
    return ::SearchPathW(nullptr, fs::path(program).c_str(), L".exe", 0, nullptr, nullptr) != 0;
}

}  // namespace nullscope::platform
