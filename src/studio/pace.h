// How the window's loop keeps time: how long it waits and for what, which frames are due, how far a turn moves. s, where nothing else is said.
#pragma once

namespace nullscope::viewer {

inline constexpr int kSettlingFrames = 3;  // panels answer an event a frame later, and take another to find their size
inline constexpr int kNewsFrames = 2;      // a measured number may make its panel wider a frame later
inline constexpr double kIdleWait = 1.0;   // s
inline constexpr double kCaretWait = 0.1;  // s, while a text field shows a blinking caret
inline constexpr double kAdaptingWait = 0.03;  // s, while exposure follows
inline constexpr double kBusyWait =
    0.05;  // s between frames while a picture is awaited: the processor is the painter's
inline constexpr double kProgressWait = 0.1;      // s between looks at how far a picture is
inline constexpr double kGamepadWait = 0.016;     // s between looks at a gamepad
inline constexpr double kProgressAfter = 0.3;     // s that a picture takes before its progress is shown
inline constexpr double kFirstStep = 1.0 / 60;    // s of motion that a key's first frame stands for
inline constexpr double kLongestFrameStep = 0.1;  // s: a hitch is no leap

// What the loop has to do besides events.
struct LoopWork {
    bool minimised = false;    // nothing can be seen
    bool patient = false;      // every frame is waited for
    bool painting = false;     // a picture is awaited
    bool in_motion = false;    // without a hand
    bool caret = false;        // a text field has the keyboard
    bool in_progress = false;  // a record, a film, a dialog
    bool adapting = false;     // exposure follows
    double next = kIdleWait;   // until something else is due, at least 0
};

class Pace {
public:
    // For events; 0: do not wait.
    double wait(const LoopWork& work, double now) const;
    // A turn of the loop begins. waited: for events, with nothing in motion. How long the turn before it took, for motion.
    double begin_turn(double now, bool waited);
    double turn_began_at() const { return turn_began_at_; }

    void want(int frames) { due_ = frames > due_ ? frames : due_; }  // so many from now on, at least
    bool due() const { return due_ > 0; }
    void drawn(double now) { --due_, ++frames_, drawn_at_ = now; }
    int frames() const { return frames_; }         // drawn until now
    double drawn_at() const { return drawn_at_; }  // the last one; 0: none

private:
    int due_ = kSettlingFrames, frames_ = 0;
    double turn_began_at_ = 0.0, drawn_at_ = 0.0;
};

}  // namespace nullscope::viewer
