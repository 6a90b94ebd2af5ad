// A program that runs beside the viewer, and what it prints.
#pragma once
#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace nullscope::viewer {

class ChildProcess {
public:
    ChildProcess() = default;
    ~ChildProcess() { end(); }
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    // words: the program, by its path or its name in PATH, and its arguments. One that ran is ended. Errors: it cannot be started.
    Status start(std::vector<std::string> words);
    bool runs() const { return id_ > 0; }
    pid_t id() const { return id_; }
    std::string read();  // what it has printed, errors too, since the last time; does not wait
    std::optional<int>
    poll();  // once it has ended, and once only: its exit status, -1 where a signal ended it. read() has the rest
    void end();

private:
    void take_output();
    pid_t id_ = 0;
    int output_ = -1;
    std::string said_;
};

// Whether PATH has such a program.
bool is_in_path(const std::string& program);

}  // namespace nullscope::viewer
