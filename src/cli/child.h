// Processes that this program starts: workers and ffmpeg.
#pragma once
#include <sys/types.h>

#include <functional>
#include <string>

namespace nullscope::cli {

// A process that runs `run` and ends with the status that it returns. It ends (SIGTERM) when this one does, however that
// ends. -1: none could be made (errno). Where this process has threads, `run` may call only what a signal handler may.
pid_t fork_child(const std::function<int()>& run);

// Waits for its end. Empty: status 0; else "exit status 3" or "Killed", the signal's name.
std::string end_of_child(pid_t child);

}  // namespace nullscope::cli
