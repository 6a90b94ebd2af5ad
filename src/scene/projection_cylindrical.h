// Longitude u to the right, v the tangent of the latitude.
#pragma once
#include <algorithm>

#include "scene/projection_pinhole.h"

namespace nullscope {

inline constexpr ProjectionRow kCylindricalProjection{
    .name = "cylindrical",
    .is = "",
    .effect = "cylindrical",
    .define = "EFFECT_CYLINDRICAL",
    .help = "The picture lies on a cylinder round the camera.",
    .cost = "sine and cosine a pixel",
    .field = kFieldAllRound,
    .direction =
        [](ImagePlace at) {
            return Vec3{std::sin(at.u), at.v, -std::cos(at.u)};
        },
    .place = [](Vec3 d) -> std::optional<ImagePlace> {
        const double level = std::hypot(d.x, d.z);
        if (!(level > 0.0)) return std::nullopt;
        return ImagePlace{std::atan2(d.x, -d.z), d.y / level};
    },
    .area =
        [](ImagePlace at) {
            return pinhole_area({0.0, at.v});
        },
    .angle =
        [](double pixel, ImagePlace at) {
            return pinhole_angle(pixel, {0.0, at.v});
        },
    .aside = [](double right, double up,
                double pixel) { return std::min(std::hypot(right * pixel, std::atan(up * pixel)), M_PI); },
    .round = true,
};

}  // namespace nullscope
