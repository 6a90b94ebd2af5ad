#include "studio/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

#include "base/text.h"

extern char** environ;

namespace nullscope::viewer {

Status ChildProcess::start(std::vector<std::string> words) {
    end();
    said_.clear();
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) return failed(std::strerror(errno));
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
    const int failure = ::posix_spawnp(&id_, arguments.front(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    output_ = ends[0];
    if (failure == 0) return Done{};
    id_ = 0;
    ::close(std::exchange(output_, -1));
    return failed(fmt::format("{}: {}", words.front(), std::strerror(failure)));
}

void ChildProcess::take_output() {
    std::array<char, 4096> bytes;
    for (ssize_t count = 0; output_ >= 0 && (count = ::read(output_, bytes.data(), bytes.size())) > 0;)
        said_.append(bytes.data(), static_cast<std::size_t>(count));
}

std::string ChildProcess::read() {
    take_output();
    return std::exchange(said_, {});
}

std::optional<int> ChildProcess::poll() {
    int status = 0;
    if (id_ == 0 || ::waitpid(id_, &status, WNOHANG) != id_) return std::nullopt;
    take_output();
    ::close(std::exchange(output_, -1));
    id_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void ChildProcess::end() {
    if (id_ == 0) return;
    ::kill(id_, SIGTERM);
    ::waitpid(id_, nullptr, 0);
    ::close(std::exchange(output_, -1));
    id_ = 0;
}

bool is_in_path(const std::string& program) {
    const char* path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): nobody sets it meanwhile
    return std::ranges::any_of(split(path != nullptr ? path : "", ':'), [&](const std::string& folder) {
        return ::access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0;
    });
}

}  // namespace nullscope::viewer
