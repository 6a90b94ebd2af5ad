// The hard cases, one named list: views at which formulas degenerate, cancel or run out of digits. Every test of frames, of the
// shader core and of the drivers goes through it, and `nullscope bench hard` prints what each one measures.
#pragma once
#include <string>
#include <vector>

#include "scene/ray.h"
#include "scene/scene.h"

namespace nullscope {

struct HardCase {
    std::string name;  // unique
    std::string why;   // what is hard about it
    Scene scene;       // a small frame, sky black (nothing but rays is asked for)
};

const std::vector<HardCase>& hard_cases();

// What a frame may err by, px: the last bit of the input (a view direction in float, of order 1) times the condition number of the
// question, times a small factor for the roundings between them; and the interpolation error of the tables over the same angle.
// The condition number is 1 / pixel angle, for the screen error has divided out how far the answer moves; a swept angle of many
// half turns has as much more; and a place on the disc close to the camera is stored with the last bit of its own coordinates.
// A frequency has the condition numbers of the camera's radius, |d ln(lapse)/d ln r|, and of its speed, gamma^2: both
// are inputs in double.
inline constexpr double kFloatBit = 5.9604644775390625e-8;  // 2^-24
inline constexpr double kRoundings = 12;                    // of a direction, from its rows to the stored channel
inline constexpr double kStripLine = 1.5e-6;                // rad: table/strip.h for cosine and sine at once
// rad: the same where inward rays end in sight (wormhole, star), where the strip curves more: 1.62e-6 measured at Ellis' throat, in double and float alike.
inline constexpr double kStripLineInner = 1.8e-6;
inline constexpr double kStripCubic = 1e-7;  // rad
inline constexpr double kOrbitTable = 4e-6;  // rad: place on a disc over the distance to it
// rad, 1.1e-5 measured: rays about rotating holes are stepped (docs/accuracy.md); from further away than kMinoFar, r_s, what
// the steps err by is a part of the hole's angular size.
inline constexpr double kMinoStep = 2e-5, kMinoFar = 10;
inline constexpr double kDoubleBit = 1.1102230246251565e-16;  // 2^-53
inline constexpr double kTexel = 2 * kFloatBit;               // rad: tables hold floats, whoever reads them in double

// Frames whose pixels are so narrow that the strip's straight lines would err by 0.05 px are drawn with its cubics.
bool hard_cubic(const Scene& scene);

struct HardBound {
    double sky = 0, place = 0, swept = 0, g = 0;  // px
};
// exact: the reference's frame of the same scene. bit: the last one of what traced, kFloatBit or kDoubleBit.
HardBound hard_bound(const Scene& scene, const RayFrame& exact, double bit = kFloatBit);

}  // namespace nullscope
