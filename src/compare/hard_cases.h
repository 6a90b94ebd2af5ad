// The hard cases, one named list: views at which formulas degenerate, cancel or run out of digits. Every test of frames, of the
// shader core and of the drivers goes through it, and `nullscope bench hard` prints what each one measures.
#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

namespace nullscope {

struct HardCase {
    std::string name;   // unique
    std::string why;    // what is hard about it
    Scene scene;        // a small frame, sky black (nothing but rays is asked for)
};

const std::vector<HardCase>& hard_cases();

// What a frame may err by, px: the last bit of its input (a look direction in float, of order 1) times the condition number of the
// question, 1 / pixel angle (the screen error has divided out how far the answer moves), times a small factor for the roundings
// between them; and the interpolation error of the method's strip over the same angle.
inline constexpr double kFloatBit = 5.9604644775390625e-8;   // 2^-24
inline constexpr double kRoundings = 12;        // of a direction, from its rows to the stored channel
inline constexpr double kStripLine = 1e-6;      // rad, table/strip.h
inline constexpr double kStripCubic = 1e-7;     // rad
double hard_bound_px(const CameraSpec& camera, bool cubic);

}  // namespace nullscope
