#include "platform/usage.h"

#include <windows.h>
// Behind windows.h, whose types it needs.
#include <psapi.h>

#include <chrono>

namespace nullscope::platform {
namespace {

double seconds_of(const FILETIME& time) {
    constexpr double kTick_s = 1e-7;
    return kTick_s * (4294967296.0 * time.dwHighDateTime + time.dwLowDateTime);
}

struct Times {
    FILETIME began{}, ended{}, kernel{}, user{};
    double cpu() const { return seconds_of(kernel) + seconds_of(user); }
};

Times process_times() {
    Times times;
    ::GetProcessTimes(::GetCurrentProcess(), &times.began, &times.ended, &times.kernel, &times.user);
    return times;
}

}  // namespace

double process_seconds() {
    FILETIME now{};
    ::GetSystemTimePreciseAsFileTime(&now);
    static const double before = seconds_of(now) - seconds_of(process_times().began);
    static const auto first = std::chrono::steady_clock::now();
    return before + std::chrono::duration<double>(std::chrono::steady_clock::now() - first).count();
}

double process_cpu_seconds() { return process_times().cpu(); }

double thread_cpu_seconds() {
    Times times;
    ::GetThreadTimes(::GetCurrentThread(), &times.began, &times.ended, &times.kernel, &times.user);
    return times.cpu();
}

double resident_bytes() {
    PROCESS_MEMORY_COUNTERS memory{};
    ::K32GetProcessMemoryInfo(::GetCurrentProcess(), &memory, sizeof memory);
    return static_cast<double>(memory.WorkingSetSize);
}

void give_way() { ::SetThreadPriority(::GetCurrentThread(), THREAD_PRIORITY_BELOW_NORMAL); }

void tighten_heap() {}  // the system's heap gives back what is free

}  // namespace nullscope::platform
