#include "cli/workers.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "command/child.h"

namespace nullscope::cli {
namespace {

enum class Kind { kBegun, kDone, kFailed, kBadInput };

// In front of a text, in a pipe.
struct Message {
    Kind kind;
    int frame, length;
};

// To the parent. Where that is gone, this process has been told to end.
void tell(int pipe, Kind kind, int frame, const std::string& text) {
    const Message message{kind, frame, static_cast<int>(text.size())};
    std::string bytes(reinterpret_cast<const char*>(&message), sizeof message);
    bytes += text;
    write_all(pipe, bytes);
}

// Exceptions as main() reads them.
Status drawn_by(const std::function<Status(const FrameWatch&)>& draw, const FrameWatch& watch) {
    try {
        return draw(watch);
    } catch (const std::bad_alloc&) {
        return failed("out of memory");
    } catch (const std::exception& error) {
        return failed(error.what());
    }
}

int work(int pipe, const std::function<Status(const FrameWatch&)>& draw) {
    const FrameWatch watch{
        [&](int frame) { tell(pipe, Kind::kBegun, frame, ""); },
        [&](int frame, const std::string& line) { tell(pipe, Kind::kDone, frame, line); },
    };
    const Status drawn = drawn_by(draw, watch);
    if (drawn) return 0;
    const bool input = drawn.error().kind == ErrorKind::kBadInput;
    tell(pipe, input ? Kind::kBadInput : Kind::kFailed, 0, drawn.error().message());
    return static_cast<int>(drawn.error().kind);
}

// Held back while workers run; those that are ignored stay so.
class HeldSignals {
public:
    HeldSignals() {
        sigset_t held;
        sigemptyset(&held);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
            struct sigaction action {};
            if (::sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) sigaddset(&held, signal);
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

struct Worker {
    pid_t process = 0;  // 0: ended
    int pipe = -1;
    std::string bytes{};         // read and not yet understood
    std::optional<int> frame{};  // that it draws
};

class Workers {
public:
    Workers(const FrameWatch& watch, Progress* progress) : watch_(watch), progress_(progress) {}
    ~Workers() { end(); }
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    Status start(int count, const HeldSignals& held, const std::function<Status(const FrameWatch&)>& draw) {
        for (int i = 0; i < count; ++i) {
            std::array<int, 2> ends{};
            if (::pipe2(ends.data(), O_CLOEXEC) != 0) return failed(fmt::format("--workers: {}", std::strerror(errno)));
            const pid_t process = fork_child([&] {
                held.restore();
                return work(ends[1], draw);
            });
            const int error = errno;
            ::close(ends[1]);
            workers_.push_back({std::max(process, 0), ends[0]});
            if (process < 0) return failed(fmt::format("--workers: {}", std::strerror(error)));
        }
        return Done{};
    }

    // Until all have ended, or one has failed, or a signal comes. Returns that.
    std::optional<int> run(const HeldSignals& held) {
        while (!error_ && left() > 0) {
            std::vector<pollfd> polled{{held.descriptor(), POLLIN, 0}};
            for (const Worker& worker : workers_) polled.push_back({worker.process != 0 ? worker.pipe : -1, POLLIN, 0});
            if (::poll(polled.data(), polled.size(), -1) < 0) continue;
            if (const auto signal = held.next()) return signal;
            for (std::size_t i = 0; i < workers_.size(); ++i)
                if (polled[i + 1].revents != 0) listen(workers_[i]);
        }
        return std::nullopt;
    }

    // All of them, those that are stopped too, and waits for it.
    void end() {
        for (const Worker& worker : workers_)
            if (worker.process != 0) ::kill(worker.process, SIGTERM), ::kill(worker.process, SIGCONT);
        for (Worker& worker : workers_) {
            if (worker.process != 0) end_of_child(std::exchange(worker.process, 0));
            ::close(worker.pipe);
        }
        workers_.clear();
    }

    const std::optional<Error>& error() const { return error_; }

private:
    int left() const {
        return static_cast<int>(std::ranges::count_if(workers_, [](const Worker& w) { return w.process != 0; }));
    }

    void listen(Worker& worker) {
        std::array<char, 4096> bytes;
        const ssize_t count = ::read(worker.pipe, bytes.data(), bytes.size());
        if (count < 0) return;
        if (count == 0) return bury(worker);
        worker.bytes.append(bytes.data(), static_cast<std::size_t>(count));
        Message message{};
        while (worker.bytes.size() >= sizeof message) {
            std::memcpy(&message, worker.bytes.data(), sizeof message);
            const std::size_t end = sizeof message + static_cast<std::size_t>(message.length);
            if (worker.bytes.size() < end) return;
            take(worker, message, worker.bytes.substr(sizeof message, end - sizeof message));
            worker.bytes.erase(0, end);
        }
    }

    void take(Worker& worker, const Message& message, const std::string& text) {
        if (message.kind == Kind::kBegun) {
            worker.frame = message.frame;
            watch_.begun(message.frame);
        } else if (message.kind == Kind::kDone) {
            worker.frame.reset();
            watch_.done(message.frame, text);
        } else if (!error_) {
            error_ = message.kind == Kind::kBadInput ? bad_input(text) : failed(text);
        }
    }

    void bury(Worker& worker) {
        const std::string how = end_of_child(std::exchange(worker.process, 0));
        if (how.empty() || error_) return;
        const std::string what = worker.frame ? fmt::format("frame {}", *worker.frame) : "no frame";
        if (progress_ != nullptr) progress_->clear();
        fmt::print(stderr, "nullscope: a worker ended ({}); it was drawing {}, {} left\n", how, what,
                   left() == 0   ? "none is"
                   : left() == 1 ? "1 worker is"
                                 : fmt::format("{} workers are", left()));
    }

    const FrameWatch& watch_;
    Progress* progress_;
    std::vector<Worker> workers_;
    std::optional<Error> error_;
};

}  // namespace

Status draw_in_workers(int count, const std::function<Status(const FrameWatch&)>& draw, const FrameWatch& watch,
                       Progress* progress, const std::function<bool()>& is_missing) {
    std::optional<int> signal;
    {
        const HeldSignals held;
        Workers workers(watch, progress);
        TRY(started, workers.start(count, held, draw));
        signal = workers.run(held);
        workers.end();
        if (workers.error()) return *workers.error();
    }
    if (signal) std::raise(*signal);
    if (!is_missing()) return Done{};
    return failed("every worker has ended and frames are missing; those that are there stay");
}

}  // namespace nullscope::cli
