#include "studio/pace.h"

#include <algorithm>

namespace nullscope::viewer {

double Pace::wait(const LoopWork& work, double now) const {
    if (work.minimised) return kIdleWait;
    if (work.patient) return work.painting ? kIdleWait : 0.0;
    if (work.in_motion) return work.painting ? kBusyWait : 0.0;
    if (due()) return work.painting ? std::clamp(drawn_at_ + kBusyWait - now, 0.0, kBusyWait) : 0.0;
    if (work.caret) return kCaretWait;
    if (work.painting || work.in_progress) return kProgressWait;
    return work.adapting ? kAdaptingWait : std::min(kIdleWait, work.next);
}

double Pace::begin_turn(double now, bool waited) {
    const double since = now - turn_began_at_;
    turn_began_at_ = now;
    return waited ? kFirstStep : std::min(since, kLongestFrameStep);
}

}  // namespace nullscope::viewer
