// What a picture takes and how many of them follow each other, as the status line says it: rarely enough to be read.
#pragma once
#include <optional>

namespace nullscope::viewer {

class PictureRate {
public:
    // A picture came at `now` (s, of a steady clock). moving: pictures follow each other without a wait. whole_ms: what it took to draw;
    // nothing of a coarse one.
    void shown(double now, bool moving, std::optional<double> whole_ms);
    double picture_ms() const { return picture_ms_; }
    double fps() const { return fps_; }  // 0: at rest

    static constexpr double kInterval_s = 0.25;  // between changes of the numbers

private:
    double at_ = 0.0, changed_at_ = 0.0;
    double frame_s_ = 0.0;  // of one, as a moving mean
    double picture_ms_ = 0.0, fps_ = 0.0;
};

}  // namespace nullscope::viewer
