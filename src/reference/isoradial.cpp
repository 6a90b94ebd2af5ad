#include "reference/isoradial.h"

#include <cmath>

#include "reference/root.h"

namespace nullscope::reference {

Result<std::vector<std::array<double, 2>>> isoradial(const Scene& scene, double r, int k, int points) {
    TRY(tracer, FrameTracer::make(scene));
    const PlaneRays* rays = tracer->plane_rays();
    if (!rays) return bad_input("no isoradials about a rotating hole", "a metric without spin");
    const CameraSpec& camera = scene.camera;
    std::vector<std::array<double, 2>> curve;
    for (int i = 0; i < points; ++i) {
        const double turn = 2 * M_PI * i / points;
        const auto direction = [&](double beta) {  // beta: from the inward radial
            return Vec3{-std::cos(beta), std::sin(beta) * std::cos(turn), std::sin(beta) * std::sin(turn)};
        };
        // 1/r of the crossing less that of the ring; a ray that ends before it is too far in, or has reached the sky.
        const auto outside = [&](double beta) {
            const auto orbit = rays->orbit_of(direction(beta));
            const double angle = RayPlane(camera.theta, camera.phi, direction(beta)).crossing(k);
            if (!(angle < orbit->angle())) return orbit->fate() == Fate::kEscaped ? 1 / r : -1e3;
            return 1 / r - orbit->zeta_at(angle);
        };
        const double low = 1e-9, high = M_PI - 1e-9, at_low = outside(low), at_high = outside(high);
        if (!(at_low < 0 && at_high > 0)) continue;
        const double beta = root_of(outside, low, high, at_low, at_high, 48);
        if (const auto position = rays->position(direction(beta))) curve.push_back(*position);
    }
    return curve;
}

}  // namespace nullscope::reference
