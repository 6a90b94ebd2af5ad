// Azimuthal equidistant: hypot(u, v) from the line of sight, towards (u, v).
#pragma once
#include <algorithm>

#include "scene/projection_row.h"

namespace nullscope {

inline constexpr ProjectionRow kFisheyeProjection{
    .name = "fisheye",
    .is = "azimuthal equidistant, a dome master where the picture is square",
    .effect = "fisheye",
    .define = "EFFECT_FISHEYE",
    .help = "The camera has a fisheye lens, as for a dome.",
    .cost = "sine and cosine a pixel",
    .field = {rad(180), rad(10), rad(360), false, rad(10), rad(360)},
    .direction =
        [](ImagePlace at) {
            const double angle = std::hypot(at.u, at.v), scale = sinc(angle);
            return Vec3{scale * at.u, scale * at.v, -std::cos(angle)};
        },
    .place = [](Vec3 d) -> std::optional<ImagePlace> {
        const double aside = std::hypot(d.x, d.y), angle = std::atan2(aside, -d.z);
        return aside > 0.0 ? ImagePlace{angle * d.x / aside, angle * d.y / aside} : ImagePlace{angle, 0.0};
    },
    .area = [](ImagePlace at) { return std::fabs(sinc(std::hypot(at.u, at.v))); },
    .angle = [](double pixel, ImagePlace) { return pixel; },
    .aside = [](double right, double up, double pixel) { return std::min(std::hypot(right, up) * pixel, M_PI); },
    .shown = [](double field) { return 0.5 * field; },
    .circle = true,
};

}  // namespace nullscope
