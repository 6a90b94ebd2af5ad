// Under Windows a thread that TBB starts has the long double of the thread that asks it for work, 64 bits: status 0, or 1 and what is wrong.
// tests/windows/test_windows.py compiles and runs it with the TBB that scripts/windows.sh builds.
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <chrono>
#include <cstdio>
#include <map>
#include <mutex>
#include <thread>

namespace {

int bits_of_long_double() {
    unsigned short word = 0;
    __asm__ volatile("fnstcw %0" : "=m"(word));
    constexpr int kBits[] = {24, 0, 53, 64};  // by Intel's precision control
    return kBits[word >> 8 & 3];
}

}  // namespace

int main() {
    constexpr int kThreads = 4, kTasks = 64;
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, kThreads);
    std::mutex mutex;
    std::map<std::thread::id, int> bits;
    tbb::parallel_for(0, kTasks, [&](int) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        const std::lock_guard lock(mutex);
        bits[std::this_thread::get_id()] = bits_of_long_double();
    });
    int faults = 0;
    for (const auto& [thread, its] : bits)
        if (its != 64) std::printf("a thread's long double has %d bits\n", its), ++faults;
    if (bits.size() < 2) std::printf("TBB has started no thread\n"), ++faults;
    return faults == 0 ? 0 : 1;
}
