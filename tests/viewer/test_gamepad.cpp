#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "studio/gamepad.h"

namespace {

using nullscope::length;
using nullscope::viewer::pad_motion;
using nullscope::viewer::PadMotion;
using nullscope::viewer::PadState;

PadMotion of_axis(std::size_t axis, float value) {
    PadState pad;
    pad.axes[axis] = value;
    return pad_motion(pad, {});
}

TEST_CASE("gamepad: at rest, and within the dead zone, nothing moves") {
    CHECK_FALSE(pad_motion({}, {}).moves());
    for (std::size_t axis = 0; axis < 4; ++axis)
        for (const float value : {-0.149f, 0.149f}) CHECK_FALSE(of_axis(axis, value).moves());
    for (const std::size_t trigger : {4u, 5u}) CHECK_FALSE(of_axis(trigger, -0.71f).moves());  // 0.145 of its way
    PadState pad;
    pad.axes[0] = pad.axes[1] = 0.12f;  // together beyond it
    CHECK(pad_motion(pad, {}).moves());
}

TEST_CASE("gamepad: each axis and bumper moves its own way, evenly from the dead zone to 1") {
    CHECK(of_axis(0, 1.0f).fly.x == 1.0);
    CHECK(of_axis(0, 0.575f).fly.x == doctest::Approx(0.5));
    CHECK(of_axis(1, -1.0f).fly.z == -1.0);  // the stick forward: forward
    CHECK(of_axis(5, 1.0f).fly.y == 1.0);
    CHECK(of_axis(4, 1.0f).fly.y == -1.0);
    CHECK(of_axis(2, 1.0f).right == 1.0);
    CHECK(of_axis(3, -1.0f).up == 1.0);
    CHECK(of_axis(2, 1.0f).up == 0.0);
    PadState pad;
    pad.buttons[5] = true;
    CHECK(pad_motion(pad, pad).roll == 1.0);
    pad.buttons[4] = true;
    CHECK_FALSE(pad_motion(pad, pad).moves());
}

TEST_CASE("gamepad: no motion is longer than 1, whatever a device says") {
    PadState pad;
    pad.axes = {1.0f, 1.0f, 3.0f, -7.0f, -1.0f, 1.0f};
    const PadMotion most = pad_motion(pad, {});
    CHECK(length(most.fly) == doctest::Approx(1.0));
    CHECK(std::hypot(most.right, most.up) == doctest::Approx(1.0));
    pad.axes.fill(std::numeric_limits<float>::quiet_NaN());
    CHECK_FALSE(pad_motion(pad, {}).moves());
}

TEST_CASE("gamepad: a button counts when it goes down") {
    PadState pad;
    pad.buttons[0] = pad.buttons[1] = pad.buttons[7] = true;
    const PadMotion down = pad_motion(pad, {}), held = pad_motion(pad, pad), up = pad_motion({}, pad);
    CHECK((down.reset && down.close && down.gallery));
    CHECK_FALSE((held.reset || held.close || held.gallery));
    CHECK_FALSE((up.reset || up.close || up.gallery));
}

}  // namespace
