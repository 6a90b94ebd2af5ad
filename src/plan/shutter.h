// picture.shutter: the sub-frames of a frame of a film.
//
// A frame is the mean of its light over the time for which the shutter is open, by the midpoint rule: sub-frames at the middles of equal
// parts of that time, about the frame's own. Equal weights, because what passes a pixel leaves a step there, for which no rule is better:
// half a part of the time is its error. 16 sub-frames are within 1 % (rms over the mean light) of 256 as long as what is seen moves by
// at most kSmoothStep_px from one to the next; beyond that fast points leave dots (tests/gpu/test_shutter.cpp).
#pragma once
#include <functional>
#include <vector>

#include "scene/exposure.h"

namespace nullscope {

// at: the scene at any place between frames. Sub-frames that are equal are one with all their share: what need not be drawn is not, and
// where nothing moves there are none. varies: more than camera and time change from frame to frame. Each costs a picture; they are drawn like any other, with more rays on edges.
Exposure exposure_of(const std::function<Scene(double frame)>& at, int frame, bool varies = false);

inline constexpr double kSmoothStep_px = 2.0 / 3.0;
// How many sub-frames it takes for that, by the turn of the camera alone.
int smooth_sub_frames(const Exposure& shown);

std::vector<double> times_of(const Exposure& shown);  // of the pictures that are drawn

}  // namespace nullscope
