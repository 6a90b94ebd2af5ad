#include "scene/pixel_angle.h"

#include <cmath>

namespace nullscope {

double pixel_angle(const CameraSpec& camera, double x, double y) {
    const double pixel = camera.plane_width / camera.width / camera.focal_distance;
    const double u = (x - 0.5 * camera.width) * pixel, v = (y - 0.5 * camera.height) * pixel;
    const double inverse = 1 / std::sqrt(1 + u * u + v * v);
    return pixel * inverse * std::sqrt(inverse);
}

double smallest_pixel_angle(const CameraSpec& camera) { return pixel_angle(camera, 0, 0); }

}  // namespace nullscope
