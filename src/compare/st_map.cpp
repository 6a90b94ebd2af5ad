#include "compare/st_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "observer/pose.h"
#include "scene/projection.h"

namespace nullscope {

StPlace panorama_place(Vec3 direction) {
    const double azimuth = std::atan2(direction.y, direction.x),
                 latitude = std::atan2(direction.z, std::hypot(direction.x, direction.y));
    return {0.5 - azimuth / (2.0 * M_PI), 0.5 + latitude / M_PI};
}

std::optional<StPlace> plate_place(const CameraSpec& camera, Vec3 direction) {
    const auto pixel = pixel_of(camera, transposed(world_from_camera(camera)) * direction);
    if (!pixel) return {};
    const StPlace place{(*pixel)[0] / camera.width, 1.0 - (*pixel)[1] / camera.height};
    const bool fits = std::max(std::fabs(place[0]), std::fabs(place[1])) <= std::numeric_limits<float>::max();
    return fits ? std::optional(place) : std::nullopt;
}

Image<float> st_map(const RayFrame& rays, const std::function<std::optional<StPlace>(Vec3 direction)>& place) {
    Image<float> map(rays.width, rays.height, 3);
    float* out = map.data.data();
    for (const RayPixel& pixel : rays.pixels) {
        const auto at = pixel.fate == Fate::kEscaped ? place(pixel.sky) : std::nullopt;
        *out++ = at ? static_cast<float>((*at)[0]) : 0.0f;
        *out++ = at ? static_cast<float>((*at)[1]) : 0.0f;
        *out++ = at ? 1.0f : 0.0f;
    }
    return map;
}

}  // namespace nullscope
