// Under Windows narrow text is UTF-8 to std::filesystem::path, in the room that libstdc++ gives it: status 0, or 1 and what is wrong.
// tests/windows/test_windows.py compiles it with src/platform/windows/utf8.cpp and runs it.
#include <cstdio>
#include <cwchar>
#include <filesystem>
#include <locale>
#include <string>
#include <vector>

#include "platform/windows/utf8.h"

namespace {

int faults = 0;

void check(bool good, const char* what) {
    if (!good) std::printf("%s\n", what), ++faults;
}

// What is narrow stays itself on its way over UTF-16.
void goes_there_and_back(const std::string& narrow, const std::wstring& wide) {
    check(std::filesystem::path(narrow).wstring() == wide, "narrow text has become other text");
    check(std::filesystem::path(wide).string() == narrow, "wide text has become other text");
}

// Three bytes a character where there is room for two: none is written beyond it.
void stays_in_its_room() {
    struct Conversion : std::codecvt<wchar_t, char, std::mbstate_t> {
    } conversion;
    constexpr std::size_t kCharacters = 40, kRoom = 2 * kCharacters;
    const std::wstring wide(kCharacters, L'\u65e5');
    std::vector<char> out(4 * kCharacters, '#');
    const wchar_t* read = nullptr;
    char* written = nullptr;
    std::mbstate_t state{};
    conversion.out(state, wide.data(), wide.data() + wide.size(), read, out.data(), out.data() + kRoom, written);
    check(written <= out.data() + kRoom && out[kRoom] == '#', "text has been written beyond its room");
}

}  // namespace

int main() {
    nullscope::platform::use_utf8();
    goes_there_and_back("na\xc3\xafve 1", L"na\u00efve 1");
    goes_there_and_back("\xf0\x9f\x8c\x8c.png", L"\xd83c\xdf0c.png");  // two of UTF-16
    std::string narrow;
    std::wstring wide;
    for (int i = 0; i < 100; ++i) narrow += "\xe6\x97\xa5", wide += L'\u65e5';
    goes_there_and_back(narrow, wide);
    stays_in_its_room();
    return faults == 0 ? 0 : 1;
}
