// Stands for ffmpeg.exe, of which nobody has one under Wine: writes its arguments, a line each in UTF-8, into the file that it is asked for.
// tests/windows/test_windows.py compiles it with src/platform/windows/utf8.cpp.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "platform/windows/utf8.h"

int wmain(int count, wchar_t** words) {
    nullscope::platform::use_utf8();
    std::ofstream file(std::filesystem::path(words[count - 1]), std::ios::binary);
    for (int i = 1; i < count; ++i) file << std::filesystem::path(words[i]).string() << "\n";
    return file.flush() ? 0 : 1;
}
