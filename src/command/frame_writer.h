// Pictures of a sequence written to their files while the next ones are drawn.
#pragma once
#include <deque>
#include <functional>
#include <future>

#include "base/result.h"

namespace nullscope::cli {

// How many pictures of this many bytes are written at once, by one of several worker processes: half of the processor's threads, as far as
// 1 GiB holds them; at least one.
int pictures_written_at_once(int workers, double bytes);

// What follows a picture is done by the caller's thread, in the order in which they were added.
class FrameWriter {
public:
    explicit FrameWriter(int at_once) : at_once_(at_once) {}

    // write: in a thread of its own; after: once it has succeeded. Waits while `at_once` pictures are being written. Errors: what a picture added
    // before could not be written for; this one is not begun then.
    Status add(std::function<Status()> write, std::function<void()> after);
    // Waits for all of them. Errors: the first.
    Status finish();

private:
    struct Pending {
        std::future<Status> written;
        std::function<void()> after;
    };
    Status finish_first();

    int at_once_;
    std::deque<Pending> pending_;  // destroyed: it waits for each
};

}  // namespace nullscope::cli
