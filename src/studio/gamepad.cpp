#include "studio/gamepad.h"

#include <algorithm>
#include <cmath>

namespace nullscope::viewer {
namespace {

constexpr double kDeadZone = 0.15;
enum StickAxis { kLeftX, kLeftY, kRightX, kRightY, kLeftTrigger, kRightTrigger };
enum PadButton { kA = 0, kB = 1, kLeftBumper = 4, kRightBumper = 5, kStart = 7 };

// 0 in the dead zone, from there on evenly to 1.
double beyond_dead_zone(double deflection) {
    return std::clamp((deflection - kDeadZone) / (1.0 - kDeadZone), 0.0, 1.0);
}

double stick_axis(const PadState& pad, StickAxis which) {
    const double value = pad.axes[which];
    return std::isfinite(value) ? std::clamp(value, -1.0, 1.0) : which >= kLeftTrigger ? -1.0 : 0.0;
}

struct Stick {
    double x, y;
};

// The dead zone is round, so that a stick that goes round does not stick to its axes.
Stick stick(const PadState& pad, StickAxis x, StickAxis y) {
    const Stick raw{stick_axis(pad, x), stick_axis(pad, y)};
    const double deflection = std::hypot(raw.x, raw.y);
    if (deflection <= kDeadZone) return {0.0, 0.0};
    const double scale = beyond_dead_zone(deflection) / deflection;
    return {scale * raw.x, scale * raw.y};
}

double trigger(const PadState& pad, StickAxis which) { return beyond_dead_zone(0.5 * (stick_axis(pad, which) + 1.0)); }

}  // namespace

PadMotion pad_motion(const PadState& now, const PadState& before) {
    const auto went_down = [&](PadButton button) { return now.buttons[button] && !before.buttons[button]; };
    const Stick left = stick(now, kLeftX, kLeftY), right = stick(now, kRightX, kRightY);
    PadMotion motion;
    motion.fly = {left.x, trigger(now, kRightTrigger) - trigger(now, kLeftTrigger), left.y};
    if (const double size = length(motion.fly); size > 1.0) motion.fly = motion.fly / size;
    motion.right = right.x, motion.up = 0.0 - right.y;
    motion.roll = (now.buttons[kRightBumper] ? 1.0 : 0.0) - (now.buttons[kLeftBumper] ? 1.0 : 0.0);
    motion.reset = went_down(kA), motion.close = went_down(kB), motion.gallery = went_down(kStart);
    return motion;
}

}  // namespace nullscope::viewer
