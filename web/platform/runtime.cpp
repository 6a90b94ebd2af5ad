// What the C++ runtime asks of threads: a module's only one never ends.
#include "platform/console.h"

extern "C" int __cxa_thread_atexit(void (*)(void*), void*, void*) { return 0; }

namespace nullscope::platform {

bool is_terminal(Output) { return false; }

}  // namespace nullscope::platform
