#include "platform/failure_box.h"

#include <windows.h>

#include <filesystem>

namespace nullscope::platform {

void show_failure(const std::string& title, const std::string& text) {
    if (::GetStdHandle(STD_ERROR_HANDLE) != nullptr) return;
    const auto wide = [](const std::string& words) { return std::filesystem::path(words).wstring(); };
    ::MessageBoxW(nullptr, wide(text).c_str(), wide(title).c_str(), MB_OK | MB_ICONERROR);
}

}  // namespace nullscope::platform
