#include "platform/console.h"

#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <cstdio>
#include <cstring>
#include <initializer_list>

#include "platform/windows/utf8.h"

namespace nullscope::platform {
namespace {

// A program of windows that a command line started writes there, if it was given nothing else.
void use_console_of_parent() {
    if (::GetStdHandle(STD_ERROR_HANDLE) != nullptr || ::AttachConsole(ATTACH_PARENT_PROCESS) == 0) return;
    [[maybe_unused]] const std::FILE* const text = std::freopen("CONOUT$", "w", stdout);
    [[maybe_unused]] const std::FILE* const errors = std::freopen("CONOUT$", "w", stderr);
}

DWORD console_of(Output output) { return output == Output::kText ? STD_OUTPUT_HANDLE : STD_ERROR_HANDLE; }

}  // namespace

// A console, and not the device NUL, which _isatty takes for one.
bool is_terminal(Output output) {
    DWORD mode = 0;
    return ::GetConsoleMode(::GetStdHandle(console_of(output)), &mode) != 0;
}

void begin_console() {
    use_utf8();
    use_console_of_parent();
    _setmode(_fileno(stdin), _O_BINARY);
    _setmode(_fileno(stdout), _O_BINARY);
    _setmode(_fileno(stderr), _O_BINARY);
    ::SetConsoleOutputCP(CP_UTF8);
    for (const Output output : {Output::kText, Output::kErrors}) {
        DWORD mode = 0;
        void* const console = ::GetStdHandle(console_of(output));
        if (::GetConsoleMode(console, &mode) != 0) ::SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
    }
}

void write_error(const char* text) {
    DWORD written = 0;
    ::WriteFile(::GetStdHandle(STD_ERROR_HANDLE), text, static_cast<DWORD>(std::strlen(text)), &written, nullptr);
}

}  // namespace nullscope::platform
