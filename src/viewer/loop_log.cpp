#include "viewer/loop_log.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <sstream>

namespace nullscope::viewer {
namespace {

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

// Since the process began.
double process_seconds() {
    static const double began = began_at();
    return clock_seconds(CLOCK_BOOTTIME) - began;
}

}  // namespace

double thread_cpu_seconds() { return clock_seconds(CLOCK_THREAD_CPUTIME_ID); }

Status LoopLog::open(const std::string& path) {
    file_.open(path);
    if (!file_) return failed(fmt::format("{}: cannot be written", path));
    return Done{};
}

void LoopLog::line(const std::string& words) { file_ << words << std::endl; }

void LoopLog::turn(const Turn& turn) {
    if (!is_open()) return;
    const char* picture = !turn.picture ? "none" : turn.coarse ? "coarse" : "whole";
    bool& seen = turn.coarse ? coarse_seen_ : whole_seen_;
    if (turn.picture && !seen) {
        seen = true;
        line(fmt::format("first t={:.3f} cpu={:.3f} picture={}", process_seconds(),
                         clock_seconds(CLOCK_PROCESS_CPUTIME_ID), picture));
    }
    line(fmt::format(
        "turn t={:.3f} cpu_ms={:.1f} here={} programs={} pictures={} picture={} size={}x{} work={} age_ms={:.1f}",
        process_seconds(), turn.cpu_ms, turn.here, turn.programs, turn.pictures, picture, turn.width, turn.height,
        turn.working ? 1 : 0, turn.age_ms));
    rested_.reset();
}

void LoopLog::rest(int last_key, bool measuring) {
    const std::pair state{last_key, measuring};
    if (!is_open() || rested_ == state) return;
    rested_ = state;
    line(fmt::format("rest t={:.3f} key={} measuring={}", process_seconds(), last_key, measuring ? 1 : 0));
}

}  // namespace nullscope::viewer
