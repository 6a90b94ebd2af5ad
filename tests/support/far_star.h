// One star behind a Schwarzschild hole that is seen from far away, u Einstein radii from the axis through both.
#pragma once
#include <cmath>

#include "base/vec.h"
#include "scene/scene.h"
#include "sky/point_stars.h"

namespace nullscope::test {

// Of a star infinitely far away, rad: deflection 2/b, b = r theta (r_s = 1).
inline double einstein_angle(double r) { return std::sqrt(2.0 / r); }

// Light of both images over that of the star without a hole, in the weak field (Paczynski 1986).
inline double weak_magnification(double u) { return (u * u + 2) / (u * std::sqrt(u * u + 4)); }

inline constexpr double kEinsteinRadius_px = 40.0;

// A camera that looks at the hole from r, 320 px wide; the first of two even stars stands behind it, the other behind
// the camera. Without the hole the star's pixels would add up to about `light`.
inline Scene far_star_scene(double r, double u, double light) {
    Scene scene;
    const double pixel = einstein_angle(r) / kEinsteinRadius_px;
    scene.camera.r = r;
    scene.camera.width = 320, scene.camera.height = 240;
    scene.camera.focal_distance = 1.0;
    scene.camera.plane_width = 320 * pixel;
    scene.sky.kind = SkyKind::kPoints;
    scene.sky.uniform_stars = 2;
    scene.sky.yaw = 0.7;  // along no axis: its float is not its direction
    scene.sky.magnitude_limit = 0.0;
    const PointStar star = (*point_stars(scene.sky, {}))[0];
    scene.sky.brightness = light * pixel * pixel / star.flux;
    const Vec3 aside = normalized(cross(star.direction, Vec3{0.3, -0.5, 0.8}));
    const Vec3 e = -(std::cos(u * einstein_angle(r)) * star.direction + std::sin(u * einstein_angle(r)) * aside);
    scene.camera.theta = std::atan2(std::hypot(e.x, e.y), e.z);
    scene.camera.phi = std::atan2(e.y, e.x);
    return scene;
}

}  // namespace nullscope::test
