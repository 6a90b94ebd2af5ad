// Timing for the benches: wall and CPU time of one draw, medians; and the subcommands that share them.
#pragma once
#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

#include "cli/command.h"
#include "gl/gl.h"

namespace nullscope::cli {

void add_bench_frames(Command& bench);
void add_bench_accuracy(Command& bench);
void add_bench_hard(Command& bench);
void add_bench_soak(Command& bench);
void add_bench_metrics(Command& bench);
void add_bench_spin(Command& bench);

inline double process_seconds() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Samples {
    std::vector<double> wall_ms, core_s;
};

template <class Draw>
void time_one(Samples& samples, Draw&& draw) {
    gl::finish();
    const double core = process_seconds();
    const auto start = std::chrono::steady_clock::now();
    draw();
    gl::finish();
    samples.wall_ms.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    samples.core_s.push_back(process_seconds() - core);
}

inline double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

}  // namespace nullscope::cli
