// A plane's picture: (u, v, -1), not of unit length.
#pragma once
#include "scene/projection_row.h"

namespace nullscope {

inline double pinhole_area(ImagePlace at) { return std::pow(1 + at.u * at.u + at.v * at.v, -1.5); }
inline double pinhole_angle(double pixel, ImagePlace at) {
    const double inverse = 1 / std::sqrt(1 + at.u * at.u + at.v * at.v);
    return pixel * inverse * std::sqrt(inverse);
}

inline constexpr ProjectionRow kPinholeProjection{
    .name = "pinhole",
    .is = "",
    .effect = "",
    .define = "",
    .help = "",
    .cost = "",
    .field = {rad(60), 0.0, rad(180), true, rad(1), rad(170)},
    .direction =
        [](ImagePlace at) {
            return Vec3{at.u, at.v, -1.0};
        },
    .place = [](Vec3 d) -> std::optional<ImagePlace> {
        const double ahead = -d.z;
        if (!(ahead > 0.0)) return std::nullopt;
        return ImagePlace{d.x / ahead, d.y / ahead};
    },
    .area = pinhole_area,
    .angle = pinhole_angle,
    .aside = [](double right, double up, double pixel) { return std::atan(std::hypot(right, up) * pixel); },
    .width = [](double angle) { return 2.0 * std::tan(0.5 * angle); },
    .field_of_width = [](double width) { return 2.0 * std::atan(0.5 * width); },
    .flat = true,
    .fits = "TAN",
    .fits_is = "gnomonic: tangents are linear",
};

}  // namespace nullscope
