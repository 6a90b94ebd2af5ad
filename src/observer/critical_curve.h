// The critical curve over a camera's picture: the directions of observer/critical_light.h as lines.
#pragma once
#include <array>
#include <vector>

#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope {

// Pixel positions (column, row from the top, centres at +0.5), also outside of the picture. Every point lies on the curve.
using PictureLine = std::vector<std::array<double, 2>>;

// Closed, where all of it is before the camera, in one line whose ends meet; else the parts up to 88 degrees from the middle. Lines depart
// from the curve by about 0.1 px. Nothing where CriticalLight has none. About 0.2 ms.
std::vector<PictureLine> critical_curve(const Spacetime& spacetime, const CameraSpec& camera, const LightSpec& light);

}  // namespace nullscope
