// The scale of a picture that shows a hole from afar.
#pragma once
#include <array>
#include <optional>

#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope {

inline constexpr double kLeastScaleRadius = 20.0;  // r_s; nearer, a hole is no small thing in a picture

// Whether lengths are in r_s: not in wormholes.
bool has_scale(const Spacetime& spacetime);

// How far apart two rays are in the picture that pass the centre on opposite sides, each at an impact parameter of half
// a `length`.
struct PictureScale {
    double sine;    // sin(angle to the radial direction)/impact parameter: lapse/areal radius
    double per_px;  // tangent of what a pixel spans in the middle
    // For a static camera about a spherical hole exactly, px = 2 tan(asin(sine length/2))/per_px: length/(r per_px) far
    // away. About a rotating one but for terms of a M/r^2. length: r_s, 0 <= sine length/2 < 1.
    double px(double length) const;
    // The impact parameter that a pixel stands for at the centre, r_s. At an angle of alpha from it a place has 1/cos(alpha) times too much by it:
    // 3.4e-8 at the shadow's edge from r = 1e4, 3.3e-4 from 100.
    double length_per_px() const { return per_px / sine; }
    // Of a ray that is seen that many px from the centre, r_s: the inverse of px(), exact where that is.
    double impact(double off_centre_px) const;
};
// Nothing where there is none: the camera moves, is nearer than kLeastScaleRadius, or looks aside, by more than 3
// degrees; in wormholes; where the projection is no pinhole's with square pixels.
std::optional<PictureScale> picture_scale(const Spacetime& spacetime, const CameraSpec& camera);

// Where the direction to the centre is seen, px from the picture's upper left corner. Nothing where it is not: behind a pinhole, in a zoom
// that no double direction tells apart.
std::optional<std::array<double, 2>> centre_px(const Spacetime& spacetime, const CameraSpec& camera);

}  // namespace nullscope
