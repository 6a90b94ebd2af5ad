#include "platform/process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "platform/fork.h"

extern char** environ;

namespace nullscope::platform {
namespace {

constexpr int kGivesWay = 10;   // of niceness
constexpr int kNotFound = 127;  // as a shell says it

// For exec, as long as `words` stays.
std::vector<char*> arguments_of(std::vector<std::string>& words) {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    return arguments;
}

}  // namespace

int process_id() { return ::getpid(); }
bool is_running(int process) { return ::kill(process, 0) == 0 || errno == EPERM; }

std::string Program::start(std::vector<std::string> words) {
    end();
    said_.clear();
    const std::vector<char*> arguments = arguments_of(words);
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) return std::strerror(errno);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
    pid_t process = 0;
    const int failure = ::posix_spawnp(&process, arguments.front(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    output_ = ends[0];
    if (failure == 0) return process_ = process, "";
    close_output();
    return words.front() + ": " + std::strerror(failure);
}

void Program::give_way() const { ::setpriority(PRIO_PROCESS, static_cast<id_t>(process_), kGivesWay); }

void Program::take_output() {
    std::array<char, 4096> bytes;
    for (ssize_t count = 0;
         output_ >= 0 && (count = ::read(static_cast<int>(output_), bytes.data(), bytes.size())) > 0;)
        said_.append(bytes.data(), static_cast<std::size_t>(count));
}

void Program::close_output() { ::close(static_cast<int>(std::exchange(output_, -1))); }

std::string Program::read() {
    take_output();
    return std::exchange(said_, {});
}

std::optional<int> Program::poll() {
    int status = 0;
    if (process_ == 0 || ::waitpid(static_cast<pid_t>(process_), &status, WNOHANG) != process_) return std::nullopt;
    take_output();
    close_output();
    process_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void Program::end() {
    if (process_ == 0) return;
    ::kill(static_cast<pid_t>(process_), SIGTERM);
    ::waitpid(static_cast<pid_t>(process_), nullptr, 0);
    close_output();
    process_ = 0;
}

Ran run_program(std::vector<std::string> words) {
    const std::vector<char*> arguments = arguments_of(words);
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return {std::strerror(errno)};
    const long child = fork_child([&] {
        const int nothing = ::open("/dev/null", O_RDWR);
        ::dup2(nothing, STDIN_FILENO), ::dup2(nothing, STDOUT_FILENO), ::dup2(ends[1], STDERR_FILENO);
        ::execvp(arguments.front(), arguments.data());
        return kNotFound;
    });
    ::close(ends[1]);
    std::string text;
    std::array<char, 4096> bytes;
    for (ssize_t count = 0; child > 0 && (count = ::read(ends[0], bytes.data(), bytes.size())) != 0;)
        if (count > 0 && text.find('\n') == std::string::npos)
            text.append(bytes.data(), static_cast<std::size_t>(count));
        else if (count < 0 && errno != EINTR)
            break;
    ::close(ends[0]);
    if (child < 0) return {std::strerror(errno)};
    const std::string how = end_of_child(child);
    return {how, text.substr(0, text.find('\n')), how != "exit status " + std::to_string(kNotFound)};
}

}  // namespace nullscope::platform
