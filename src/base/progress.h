// Progress of long work on standard error: a bar on a terminal, one plain line every few seconds elsewhere.
#pragma once
#include <atomic>
#include <functional>
#include <mutex>
#include <string>

#include "base/stopwatch.h"

namespace nullscope {

class Progress {
public:
    // total: units of work; nothing is printed before half a second has passed.
    Progress(std::string label, long long total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void advance(long long units = 1);  // thread-safe
    void clear();                       // takes the bar off the terminal, so that a line can be printed in its place

private:
    void print(double elapsed_s, bool last);
    std::string label_;
    long long total_;
    std::atomic<long long> done_{0};
    Stopwatch watch_;
    std::mutex mutex_;
    double last_print_s_ = 0.0;
    bool terminal_ = false;
    bool printed_ = false;
};

// What long work tells of itself: begun with what it is and its units, told of each done, from any thread; over when the function is gone.
using Advance = std::function<void(long long units)>;
using BeginProgress = std::function<Advance(const std::string& label, long long total)>;
Advance progress_on_terminal(const std::string& label, long long total);  // a Progress

}  // namespace nullscope
