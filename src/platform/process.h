// Processes: this one, and programs that it starts.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace nullscope::platform {

int process_id();              // of this process
bool is_running(int process);  // a process of that number

// A program that runs beside this one, and what it prints.
class Program {
public:
    Program() = default;
    ~Program() { end(); }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    // words: the program, by its path or its name in PATH, and its arguments: no shell reads them. One that ran is ended. Returns why it
    // cannot be started; empty: it runs.
    std::string start(std::vector<std::string> words);
    bool runs() const { return process_ != 0; }
    void give_way() const;  // it runs after others
    std::string read();     // what it has printed, errors too, since the last time; does not wait
    // Once it has ended, and once only: its exit status, -1 where a signal ended it. read() has the rest.
    std::optional<int> poll();
    void end();

private:
    void take_output();
    void close_output();
    long long process_ = 0, output_ = -1;  // the system's
    std::string said_;
};

struct Ran {
    std::string
        how;  // it ended: empty: with status 0; "exit status 3"; "Killed", the signal's name; or why it could not be started
    std::string said{};  // the first line on its standard error
    bool found = true;   // there is such a program
};

// Runs a program to its end, without input; what it writes to standard output is lost. words: as start() has them. It ends when this process
// does, however that ends.
Ran run_program(std::vector<std::string> words);

}  // namespace nullscope::platform
