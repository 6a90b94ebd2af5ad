#include "cli/workers.h"

#include <fmt/format.h>

#include <csignal>
#include <cstring>
#include <new>
#include <optional>
#include <vector>

#include "platform/fork.h"

namespace nullscope::cli {
namespace {

enum class Kind { kBegun, kDone, kFailed, kBadInput, kFinished };

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
    platform::write_all(pipe, bytes);
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
    if (drawn) {
        tell(pipe, Kind::kFinished, 0, "");
        return 0;
    }
    const bool input = drawn.error().kind == ErrorKind::kBadInput;
    tell(pipe, input ? Kind::kBadInput : Kind::kFailed, 0, drawn.error().message());
    return static_cast<int>(drawn.error().kind);
}

struct Worker {
    std::string bytes{};         // read and not yet understood
    std::optional<int> frame{};  // that it draws
    bool finished = false;       // by its own word: on Windows what ends a process gives it a status, which may be 0
};

class Workers {
public:
    Workers(const FrameWatch& watch, Progress* progress) : watch_(watch), progress_(progress) {}

    Status start(int count, const std::function<Status(const FrameWatch&)>& draw) {
        workers_.resize(static_cast<std::size_t>(count));
        if (const std::error_code error = crew_.start(count, [&](int pipe) { return work(pipe, draw); }))
            return failed(fmt::format("--workers: {}", error.message()));
        return Done{};
    }

    // Until all have ended, or one has failed, or a signal comes. Returns that.
    std::optional<int> run() {
        std::vector<platform::Crew::News> news;
        while (!error_ && crew_.left() > 0) {
            if (const auto signal = crew_.wait(news)) return signal;
            for (const platform::Crew::News& told : news)
                if (told.end)
                    bury(workers_[told.worker], *told.end);
                else
                    listen(workers_[told.worker], told.bytes);
        }
        return std::nullopt;
    }

    void end() { crew_.end(); }
    const std::optional<Error>& error() const { return error_; }

private:
    void listen(Worker& worker, const std::string& bytes) {
        worker.bytes += bytes;
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
        } else if (message.kind == Kind::kFinished) {
            worker.finished = true;
        } else if (!error_) {
            error_ = message.kind == Kind::kBadInput ? bad_input(text) : failed(text);
        }
    }

    void bury(const Worker& worker, const std::string& how) {
        if (worker.finished || error_) return;
        const std::string what = worker.frame ? fmt::format("frame {}", *worker.frame) : "no frame";
        if (progress_ != nullptr) progress_->clear();
        fmt::print(stderr, "nullscope: a worker ended ({}); it was drawing {}, {} left\n",
                   how.empty() ? "exit status 0" : how, what,
                   crew_.left() == 0   ? "none is"
                   : crew_.left() == 1 ? "1 worker is"
                                       : fmt::format("{} workers are", crew_.left()));
    }

    const FrameWatch& watch_;
    Progress* progress_;
    platform::Crew crew_;
    std::vector<Worker> workers_;
    std::optional<Error> error_;
};

}  // namespace

Status draw_in_workers(int count, const std::function<Status(const FrameWatch&)>& draw, const FrameWatch& watch,
                       Progress* progress, const std::function<bool()>& is_missing) {
    std::optional<int> signal;
    {
        Workers workers(watch, progress);
        TRY(started, workers.start(count, draw));
        signal = workers.run();
        workers.end();
        if (workers.error()) return *workers.error();
    }
    if (signal) std::raise(*signal);
    if (!is_missing()) return Done{};
    return failed("every worker has ended and frames are missing; those that are there stay");
}

}  // namespace nullscope::cli
