#include "reference/isoradial.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>

namespace nullscope::reference {

Result<std::vector<std::array<double, 2>>> isoradial(const Scene& scene, double r, int k, int points) {
    const auto tracer = FrameTracer::make(scene);
    if (!tracer) return tracer.error();
    const PlaneRays* rays = tracer->plane_rays();
    if (!rays) return bad_input("no isoradials about a rotating hole; allowed: a metric without spin");
    const CameraSpec& camera = scene.camera;
    std::vector<std::array<double, 2>> curve;
    for (int i = 0; i < points; ++i) {
        const double turn = 2 * M_PI * i / points;
        const auto look = [&](double beta) {  // beta: from the inward radial
            return Vec3{-std::cos(beta), std::sin(beta) * std::cos(turn), std::sin(beta) * std::sin(turn)};
        };
        // 1/r of the crossing less that of the ring; a ray that ends before it is too far in, or has reached the sky.
        const auto outside = [&](double beta) {
            const auto orbit = rays->orbit_of(look(beta));
            const double angle = RayPlane(camera.theta, camera.phi, look(beta)).crossing(k);
            if (!(angle < orbit->angle())) return orbit->fate() == Fate::kEscaped ? 1 / r : -1e3;
            return 1 / r - orbit->zeta_at(angle);
        };
        double low = 1e-9, high = M_PI - 1e-9;
        if (!(outside(low) < 0 && outside(high) > 0)) continue;
        std::uintmax_t most = 200;
        const auto found =
            boost::math::tools::toms748_solve(outside, low, high, boost::math::tools::eps_tolerance<double>(48), most);
        const double beta = 0.5 * (found.first + found.second);
        if (const auto position = rays->position(look(beta))) curve.push_back(*position);
    }
    return curve;
}

}  // namespace nullscope::reference
