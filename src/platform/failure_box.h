// Failures of programs of windows, which a click may have started.
#pragma once
#include <string>

namespace nullscope::platform {

// text, in UTF-8, has been written to standard error. Windows: shows it in a box, and waits, where there is no standard error. POSIX: nothing.
void show_failure(const std::string& title, const std::string& text);

}  // namespace nullscope::platform
