// The frames of one run, drawn by several processes.
#pragma once
#include <functional>
#include <string>

#include "base/progress.h"
#include "base/result.h"

namespace nullscope::cli {

// What whoever draws frames tells of each.
struct FrameWatch {
    std::function<void(int frame)> begun;
    // It is on disk: drawn now (line: what is printed of it, may be empty), or there before.
    std::function<void(int frame, const std::string& line)> done;
};

// Runs `draw` in `count` processes at once, a crew's (platform/fork.h): forked here, a process without threads, or come here by themselves. What they tell `watch` is told here, as it
// comes; a frame may be told of by each. A worker that dies is reported in one line (progress: in place of its bar), and what
// it was drawing is left to the others. The signals SIGINT, SIGTERM and SIGHUP end the workers first, then this process.
// Errors: the first of a worker, which ends the others; none is left and `is_missing` says that there is work.
Status draw_in_workers(int count, const std::function<Status(const FrameWatch&)>& draw, const FrameWatch& watch,
                       Progress* progress, const std::function<bool()>& is_missing);

}  // namespace nullscope::cli
