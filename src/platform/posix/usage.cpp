#include "platform/usage.h"

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <sstream>
#include <string>

namespace nullscope::platform {
namespace {

constexpr int kNiceness = 5;

double clock_seconds(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// When the process began, s since the machine started: field 22 of /proc/self/stat, in ticks. Where there is none: now.
double began_at() {
    constexpr int kFieldsAfterName = 19;  // field 22, counted from field 3, which follows the name in brackets
    std::ifstream file("/proc/self/stat");
    std::string text, field;
    std::getline(file, text);
    std::istringstream fields(text.substr(std::min(text.rfind(')') + 1, text.size())));
    for (int i = 0; i <= kFieldsAfterName; ++i) fields >> field;
    const double ticks = static_cast<double>(sysconf(_SC_CLK_TCK));
    return fields ? std::stod(field) / ticks : clock_seconds(CLOCK_BOOTTIME);
}

}  // namespace

double process_seconds() {
    static const double began = began_at();
    return clock_seconds(CLOCK_BOOTTIME) - began;
}

double process_cpu_seconds() { return clock_seconds(CLOCK_PROCESS_CPUTIME_ID); }
double thread_cpu_seconds() { return clock_seconds(CLOCK_THREAD_CPUTIME_ID); }

double resident_bytes() {
    std::ifstream file("/proc/self/statm");
    double all = 0, resident = 0;
    file >> all >> resident;
    return resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

void give_way() { [[maybe_unused]] const int niceness = ::nice(kNiceness); }  // Linux: of this thread alone

void tighten_heap() {
    ::mallopt(M_ARENA_MAX, 1);
    ::mallopt(M_TRIM_THRESHOLD, 1 << 17);
    ::mallopt(M_MMAP_THRESHOLD, 1 << 17);
}

}  // namespace nullscope::platform
