#include "studio/picture_rate.h"

#include <utility>

namespace nullscope::viewer {

void PictureRate::shown(double now, bool moving, std::optional<double> whole_ms) {
    constexpr double kMemory = 0.9;
    const double between = now - std::exchange(at_, now);
    frame_s_ = !moving ? 0.0 : frame_s_ > 0.0 ? kMemory * frame_s_ + (1.0 - kMemory) * between : between;
    if (moving && now - changed_at_ < kInterval_s) return;
    changed_at_ = now;
    picture_ms_ = whole_ms.value_or(picture_ms_);
    fps_ = frame_s_ > 0.0 ? 1.0 / frame_s_ : 0.0;
}

}  // namespace nullscope::viewer
