// What angle a pixel of a pinhole camera spans, in the camera's own rest frame.
#pragma once
#include <cmath>

#include "scene/scene.h"

namespace nullscope {

// rad, at position (x, y) in px from the top left corner: the square root of the solid angle.
inline double pixel_angle(const CameraSpec& camera, double x, double y) {
    const double pixel = camera.pixel();
    const double u = (x - 0.5 * camera.width) * pixel, v = (y - 0.5 * camera.height) * pixel;
    const double inverse = 1 / std::sqrt(1 + u * u + v * v);
    return pixel * inverse * std::sqrt(inverse);
}
// The least in the frame: in its corners.
inline double smallest_pixel_angle(const CameraSpec& camera) { return pixel_angle(camera, 0, 0); }

}  // namespace nullscope
