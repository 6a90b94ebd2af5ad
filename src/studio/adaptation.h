// Exposure that adapts follows like an eye, from picture to picture, until it has come to rest.
#pragma once

namespace nullscope::viewer {

class Adaptation {
public:
    void begin() { left_ = 1.0; }  // the scene is another
    // What share of its way exposure goes in the picture that is asked for at `now` (s). at_once: all of it.
    double step(double now, bool at_once);
    bool goes_on() const { return left_ > kAdapted; }

    static constexpr double kTime_s = 0.4;    // in which it goes all but 1/e of its way
    static constexpr double kAdapted = 2e-3;  // of its way: what remains is not seen

private:
    double at_ = 0.0, left_ = 0.0;  // left: what share of its way is still before it
};

}  // namespace nullscope::viewer
