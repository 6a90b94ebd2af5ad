// Standard output and standard error.
#pragma once

namespace nullscope::platform {

enum class Output { kText, kErrors };

bool is_terminal(Output output);

// For main(), before anything is written: bytes go out as they are, in UTF-8, and a terminal understands escape sequences. POSIX: as it is.
void begin_console();

// To standard error; may be called by a signal handler.
void write_error(const char* text);

}  // namespace nullscope::platform
