// Wall time since it was made.
#pragma once
#include <chrono>

namespace nullscope {

struct Stopwatch {
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); }
    double ms() const { return 1e3 * seconds(); }
};

}  // namespace nullscope
