#include "viewer/loop_log.h"

#include <fmt/format.h>

#include "platform/usage.h"

namespace nullscope::viewer {

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
        line(fmt::format("first t={:.3f} cpu={:.3f} picture={}", platform::process_seconds(),
                         platform::process_cpu_seconds(), picture));
    }
    line(fmt::format(
        "turn t={:.3f} cpu_ms={:.1f} here={} programs={} pictures={} picture={} size={}x{} work={} age_ms={:.1f}",
        platform::process_seconds(), turn.cpu_ms, turn.here, turn.programs, turn.pictures, picture, turn.width,
        turn.height, turn.working ? 1 : 0, turn.age_ms));
    rested_.reset();
}

void LoopLog::rest(int last_key, bool measuring) {
    const std::pair state{last_key, measuring};
    if (!is_open() || rested_ == state) return;
    rested_ = state;
    line(fmt::format("rest t={:.3f} key={} measuring={}", platform::process_seconds(), last_key, measuring ? 1 : 0));
}

}  // namespace nullscope::viewer
