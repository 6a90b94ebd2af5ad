#include "platform/console.h"

#include <unistd.h>

#include <cstring>

namespace nullscope::platform {

bool is_terminal(Output output) { return ::isatty(output == Output::kText ? STDOUT_FILENO : STDERR_FILENO) == 1; }

void begin_console() {}

void write_error(const char* text) {
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text, std::strlen(text));
}

}  // namespace nullscope::platform
