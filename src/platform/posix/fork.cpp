#include "platform/fork.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <utility>

namespace nullscope::platform {
namespace {

std::error_code last_error_of(int number) { return {number, std::generic_category()}; }

std::string in_digits(double number) {  // as a sentence has it: 60, 0.2
    std::string text = std::to_string(number);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

}  // namespace

bool can_fork() { return true; }

long fork_child(const std::function<int()>& run) {
    const pid_t parent = ::getpid(), child = ::fork();
    if (child != 0) return child;
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != parent) ::_exit(1);  // it ended before it could be watched
    ::_exit(run());                         // the buffers and files of the parent are its own to finish
}

std::string end_of_child(long child) {
    int status = 0;
    while (::waitpid(static_cast<pid_t>(child), &status, 0) < 0)
        if (errno != EINTR) return std::strerror(errno);
    if (WIFSIGNALED(status)) return ::strsignal(WTERMSIG(status));
    return WEXITSTATUS(status) == 0 ? "" : "exit status " + std::to_string(WEXITSTATUS(status));
}

void write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) return;
        if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
    }
}

std::error_code answer_of_child(const std::function<int(int pipe)>& run, double limit_s, ChildAnswer& answer) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return last_error_of(errno);
    const long child = fork_child([&] { return run(ends[1]); });
    const int error = errno;
    ::close(ends[1]);
    if (child < 0) return ::close(ends[0]), last_error_of(error);
    bool late = false;
    const auto begun = std::chrono::steady_clock::now();
    for (;;) {
        const double passed_ms =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
        pollfd polled{ends[0], POLLIN, 0};
        const int ready = ::poll(&polled, 1, static_cast<int>(std::max(0.0, 1e3 * limit_s - passed_ms) + 1));
        if (ready < 0 && errno == EINTR) continue;
        late = ready <= 0;
        if (late) break;
        std::array<char, 65536> bytes;
        const ssize_t count = ::read(ends[0], bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) break;
        answer.bytes.append(bytes.data(), static_cast<std::size_t>(count));
    }
    if (late) ::kill(static_cast<pid_t>(child), SIGKILL);
    ::close(ends[0]);
    answer.end = end_of_child(child);
    if (late) answer.end = "no end within " + in_digits(limit_s) + " s";
    return {};
}

struct Crew::Members {
    // Held back; those that are ignored stay so.
    class HeldSignals {
    public:
        HeldSignals() {
            sigset_t held;
            sigemptyset(&held);
            for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
                struct sigaction action {};
                if (::sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN)
                    sigaddset(&held, signal);
            }
            ::sigprocmask(SIG_BLOCK, &held, &before_);
            descriptor_ = ::signalfd(-1, &held, SFD_CLOEXEC | SFD_NONBLOCK);
        }
        ~HeldSignals() {
            ::close(descriptor_);
            restore();
        }
        HeldSignals(const HeldSignals&) = delete;
        HeldSignals& operator=(const HeldSignals&) = delete;
        void restore() const { ::sigprocmask(SIG_SETMASK, &before_, nullptr); }
        int descriptor() const { return descriptor_; }
        std::optional<int> next() const {
            signalfd_siginfo info{};
            if (::read(descriptor_, &info, sizeof info) != sizeof info) return std::nullopt;
            return static_cast<int>(info.ssi_signo);
        }

    private:
        sigset_t before_{};
        int descriptor_;
    };
    struct Member {
        long process = 0;  // 0: ended
        int pipe = -1;
    };
    HeldSignals held;
    std::vector<Member> all;
};

bool Crew::is_member() { return false; }

Crew::Crew() : members_(std::make_unique<Members>()) {}
Crew::~Crew() { end(); }

std::error_code Crew::start(int count, const std::function<int(int pipe)>& run) {
    for (int i = 0; i < count; ++i) {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) return last_error_of(errno);
        const long process = fork_child([&] {
            members_->held.restore();
            return run(ends[1]);
        });
        const int error = errno;
        ::close(ends[1]);
        members_->all.push_back({std::max(process, 0L), ends[0]});
        if (process < 0) return last_error_of(error);
    }
    return {};
}

std::optional<int> Crew::wait(std::vector<News>& news) {
    news.clear();
    std::vector<pollfd> polled{{members_->held.descriptor(), POLLIN, 0}};
    for (const auto& member : members_->all) polled.push_back({member.process != 0 ? member.pipe : -1, POLLIN, 0});
    if (::poll(polled.data(), polled.size(), -1) < 0) return std::nullopt;
    if (const auto signal = members_->held.next()) return signal;
    for (std::size_t i = 0; i < members_->all.size(); ++i) {
        if (polled[i + 1].revents == 0) continue;
        auto& member = members_->all[i];
        std::array<char, 4096> bytes;
        const ssize_t count = ::read(member.pipe, bytes.data(), bytes.size());
        if (count > 0) news.push_back({i, std::string(bytes.data(), static_cast<std::size_t>(count))});
        if (count == 0) news.push_back({i, "", end_of_child(std::exchange(member.process, 0))});
    }
    return std::nullopt;
}

int Crew::left() const {
    return static_cast<int>(std::ranges::count_if(members_->all, [](const auto& m) { return m.process != 0; }));
}

void Crew::end() {
    for (const auto& member : members_->all)
        if (member.process != 0)
            ::kill(static_cast<pid_t>(member.process), SIGTERM), ::kill(static_cast<pid_t>(member.process), SIGCONT);
    for (auto& member : members_->all) {
        if (member.process != 0) end_of_child(std::exchange(member.process, 0));
        ::close(member.pipe);
    }
    members_->all.clear();
}

}  // namespace nullscope::platform
