// Stereographic: r = 2 tan(theta/2) from the line of sight. Angles stay angles, circles stay circles; the antipode is infinitely far.
#pragma once
#include "scene/projection_row.h"

namespace nullscope {

// Over the middle's: of lengths, in every direction.
inline double stereographic_scale(ImagePlace at) { return 1.0 / (1.0 + 0.25 * (at.u * at.u + at.v * at.v)); }

inline constexpr ProjectionRow kStereographicProjection{
    .name = "stereographic",
    .is = "conformal, as in planetariums and little planets",
    .effect = "stereographic",
    .define = "EFFECT_STEREOGRAPHIC",
    .help = "The picture is stereographic: small things keep their shape, all round the camera.",
    .cost = "a division a pixel",
    .field = {rad(180), rad(10), rad(360), true, rad(10), rad(350)},
    .direction =
        [](ImagePlace at) {
            const double scale = stereographic_scale(at);
            return Vec3{scale * at.u, scale * at.v, 1.0 - 2.0 * scale};
        },
    .place = [](Vec3 d) -> std::optional<ImagePlace> {
        const double ahead = -d.z, aside2 = d.x * d.x + d.y * d.y, far = length(d),
                     sum = ahead >= 0.0 ? far + ahead : aside2 / (far - ahead);  // |d| (1 + cos(theta))
        if (!(sum > 0.0)) return std::nullopt;
        return ImagePlace{2.0 * d.x / sum, 2.0 * d.y / sum};
    },
    .area =
        [](ImagePlace at) {
            const double scale = stereographic_scale(at);
            return scale * scale;
        },
    .angle = [](double pixel, ImagePlace at) { return pixel * stereographic_scale(at); },
    .aside = [](double right, double up, double pixel) { return 2.0 * std::atan(0.5 * std::hypot(right, up) * pixel); },
    .width = [](double angle) { return 4.0 * std::tan(0.25 * angle); },
    .field_of_width = [](double width) { return 4.0 * std::atan(0.25 * width); },
    .fits = "STG",
    .fits_is = "stereographic: angles stay angles",
};

}  // namespace nullscope
