// How long the viewer's loop waits, and what it waits for. s, where nothing else is said.
#pragma once

namespace nullscope::viewer {

inline constexpr int kNewsFrames = 2;          // a measured number may make its panel wider a frame later
inline constexpr double kIdleWait = 1.0;       // s
inline constexpr double kCaretWait = 0.1;      // s, while a text field shows a blinking caret
inline constexpr double kAdaptingWait = 0.03;  // s, while exposure follows
inline constexpr double kBusyWait =
    0.05;  // s between frames while a picture is awaited: the processor is the painter's
inline constexpr double kProgressWait = 0.1;      // s between looks at how far a picture is
inline constexpr double kGamepadWait = 0.016;     // s between looks at a gamepad
inline constexpr double kProgressAfter = 0.3;     // s that a picture takes before its progress is shown
inline constexpr double kFirstStep = 1.0 / 60;    // s of motion that a key's first frame stands for
inline constexpr double kLongestFrameStep = 0.1;  // s: a hitch is no leap
inline constexpr double kMessageTime = 6.0;       // s
inline constexpr double kRestBeforeTimes = 0.5;   // s without a change before effects are measured
inline constexpr double kAdaptation = 0.4;        // s in which exposure goes all but 1/e of its way
inline constexpr double kAdapted = 2e-3;          // of its way: what remains is not seen
inline constexpr double kRateTime = 0.25;         // s between changes of the numbers in the status line

}  // namespace nullscope::viewer
