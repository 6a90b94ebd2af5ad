// What angle a pixel of a pinhole camera spans, in the camera's own rest frame.
#pragma once
#include "scene/scene.h"

namespace nullscope {

// rad, at position (x, y) in px from the top left corner: the square root of the solid angle.
double pixel_angle(const CameraSpec& camera, double x, double y);
// The least in the frame: in its corners.
double smallest_pixel_angle(const CameraSpec& camera);

}  // namespace nullscope
