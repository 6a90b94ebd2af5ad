// Processes that this program starts: workers and ffmpeg.
#pragma once
#include <sys/types.h>

#include <functional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace nullscope::cli {

// A process that runs `run` and ends with the status that it returns. It ends (SIGTERM) when this one does, however that
// ends. -1: none could be made (errno). Where this process has threads, `run` may call only what a signal handler may.
pid_t fork_child(const std::function<int()>& run);

// Waits for its end. Empty: status 0; else "exit status 3" or "Killed", the signal's name.
std::string end_of_child(pid_t child);

// What a child wrote before it ended, and how that was: as end_of_child, or "no end within 60 s".
struct ChildAnswer {
    std::string bytes, end;
};

// Runs `run` in a process of its own, which writes to the descriptor that it is given, and waits for it, at most limit_s seconds: then it is
// killed. For work that may take its process with it. Errors: no process could be made.
Result<ChildAnswer> answer_of_child(const std::function<int(int pipe)>& run, double limit_s);

// All of it, however often that takes; nothing where nobody reads any more.
void write_all(int descriptor, std::string_view bytes);

}  // namespace nullscope::cli
