#include "command/frame_writer.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace nullscope::cli {

int pictures_written_at_once(int workers, double bytes) {
    constexpr double kMost_bytes = double{1 << 30};
    const int threads = static_cast<int>(std::thread::hardware_concurrency()) / (2 * std::max(workers, 1));
    return static_cast<int>(std::clamp(kMost_bytes / std::max(bytes, 1.0), 1.0, std::max<double>(threads, 1.0)));
}

Status FrameWriter::finish_first() {
    Pending first = std::move(pending_.front());
    pending_.pop_front();
    Status written = first.written.get();
    if (written) first.after();
    return written;
}

Status FrameWriter::add(std::function<Status()> write, std::function<void()> after) {
    while (static_cast<int>(pending_.size()) >= at_once_)
        if (Status written = finish_first(); !written) return written;
    pending_.push_back({std::async(std::launch::async, std::move(write)), std::move(after)});
    return Done{};
}

Status FrameWriter::finish() {
    Status all = Done{};
    while (!pending_.empty())
        if (Status written = finish_first(); !written && all) all = std::move(written);
    return all;
}

}  // namespace nullscope::cli
