// Longitude u to the right, latitude v.
#pragma once
#include <algorithm>

#include "scene/projection_row.h"

namespace nullscope {

inline constexpr ProjectionRow kEquirectangularProjection{
    .name = "equirectangular",
    .is = "longitude and latitude",
    .effect = "equirectangular",
    .define = "EFFECT_EQUIRECTANGULAR",
    .help = "The picture has longitude and latitude, all round the camera.",
    .cost = "two sines and cosines a pixel",
    .field = kFieldAllRound,
    .direction =
        [](ImagePlace at) {
            return Vec3{std::cos(at.v) * std::sin(at.u), std::sin(at.v), -std::cos(at.v) * std::cos(at.u)};
        },
    .place = [](Vec3 d) -> std::optional<ImagePlace> {
        return ImagePlace{std::atan2(d.x, -d.z), std::atan2(d.y, std::hypot(d.x, d.z))};
    },
    .area = [](ImagePlace at) { return std::fabs(std::cos(at.v)); },
    .angle = [](double pixel, ImagePlace) { return pixel; },
    .aside = [](double right, double up, double pixel) { return std::min(std::hypot(right, up) * pixel, M_PI); },
    .shown = [](double) { return 0.5 * M_PI; },
    .round = true,
    .mesh_aspect = 2.0,
};

}  // namespace nullscope
