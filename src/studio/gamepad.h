// What a gamepad's sticks and buttons mean. Pure: no window, no GLFW, whose order of axes and buttons this is (GLFW_GAMEPAD_AXIS_*,
// GLFW_GAMEPAD_BUTTON_*).
#pragma once
#include <array>

#include "base/vec.h"

namespace nullscope::viewer {

struct PadState {
    // Left stick to the right and down, right stick likewise, -1 to 1; left and right trigger, -1 (released) to 1.
    std::array<float, 6> axes = {0, 0, 0, 0, -1, -1};
    std::array<bool, 15> buttons{};
};

struct PadMotion {
    Vec3 fly;                                            // right, up, backward; at most 1 long
    double right = 0.0, up = 0.0;                        // how the view turns, -1 to 1
    double roll = 0.0;                                   // the camera's top to its right, -1 to 1
    bool reset = false, close = false, gallery = false;  // went down
    bool moves() const { return length(fly) > 0.0 || right != 0.0 || up != 0.0 || roll != 0.0; }
};

// Of axes that are less than 0.15 from rest nothing comes; what is no number is at rest.
PadMotion pad_motion(const PadState& now, const PadState& before);

}  // namespace nullscope::viewer
