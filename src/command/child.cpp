#include "command/child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "base/stopwatch.h"

namespace nullscope::cli {

pid_t fork_child(const std::function<int()>& run) {
    const pid_t parent = ::getpid(), child = ::fork();
    if (child != 0) return child;
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != parent) ::_exit(1);  // it ended before it could be watched
    ::_exit(run());                         // the buffers and files of the parent are its own to finish
}

std::string end_of_child(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return std::strerror(errno);
    if (WIFSIGNALED(status)) return ::strsignal(WTERMSIG(status));
    return WEXITSTATUS(status) == 0 ? "" : fmt::format("exit status {}", WEXITSTATUS(status));
}

void write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) return;
        if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
    }
}

Result<ChildAnswer> answer_of_child(const std::function<int(int pipe)>& run, double limit_s) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        return failed(fmt::format("a process of its own: {}", std::strerror(errno)));
    const pid_t child = fork_child([&] { return run(ends[1]); });
    const int error = errno;
    ::close(ends[1]);
    if (child < 0) {
        ::close(ends[0]);
        return failed(fmt::format("a process of its own: {}", std::strerror(error)));
    }
    ChildAnswer answer;
    bool late = false;
    const Stopwatch watch;
    for (;;) {
        pollfd polled{ends[0], POLLIN, 0};
        const int ready = ::poll(&polled, 1, static_cast<int>(std::max(0.0, 1e3 * limit_s - watch.ms()) + 1));
        if (ready < 0 && errno == EINTR) continue;
        late = ready <= 0;
        if (late) break;
        std::array<char, 65536> bytes;
        const ssize_t count = ::read(ends[0], bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) break;
        answer.bytes.append(bytes.data(), static_cast<std::size_t>(count));
    }
    if (late) ::kill(child, SIGKILL);
    ::close(ends[0]);
    answer.end = end_of_child(child);
    if (late) answer.end = fmt::format("no end within {} s", limit_s);
    return answer;
}

}  // namespace nullscope::cli
