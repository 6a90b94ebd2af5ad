#include "reference/bodies.h"

#include <algorithm>
#include <cmath>

#include "expr/formula.h"
#include "scene/moving.h"
#include "scene/named_surface.h"

namespace nullscope::reference {
namespace {

constexpr double kInPlane = 1e-9;  // of its radius: how far off the equatorial plane a ball's place may be written
constexpr int kWayLooks = 200;     // at the way of a ball

}  // namespace

Status check_bodies(const Scene& scene, const Metric& matter) {
    if (matter.orbits() || !scene.ball) return Done{};
    const BallSpec& ball = *scene.ball;
    if (ball.motion == BallMotion::kGeodesic)
        return bad_input("ball.motion: falls are not followed about a rotating hole; allowed: still, orbit, path");
    if (ball.motion == BallMotion::kOrbit && std::abs(ball.position.z) > kInPlane * length(ball.position))
        return bad_input(
            "ball.position: orbits about a rotating hole that leave its equatorial plane are not followed; allowed: z "
            "= 0");
    return Done{};
}

double BodyPart::cosine(Vec3 place, Vec3 back, double t) const {
    const double tiny = 1e-6 * thinnest;
    const auto along = [&](Vec3 side) { return value(place + side, t) - value(place - side, t); };
    const Vec3 slope{along({tiny, 0, 0}), along({0, tiny, 0}), along({0, 0, tiny})};
    const double size = length(slope) * length(back);
    return size > 0 ? std::clamp(dot(slope, back) / size, 0.0, 1.0) : 1.0;
}

Bodies::Bodies(const Scene& scene, const Metric& matter) : time_(scene.time) {
    const auto parts = moving_parts(scene);
    moves_ = std::any_of(parts.begin(), parts.end(),
                         [](const std::string& key) { return !key.starts_with("disc") && !key.starts_with("spot"); });
    if (scene.sphere) {
        const SphereSpec s = *scene.sphere;
        BodyPart part{Object::kSphere, s.radius * (1 - s.swing), s.radius * (1 + s.swing), [s](Vec3 x, double t) {
                          return length(x) - s.radius * (1 + s.swing * std::sin(2 * M_PI * t / s.period));
                      }};
        part.moves = s.swing > 0, part.clear = s.swing == 0;
        parts_.push_back(part);
    }
    if (scene.cylinder) {
        const CylinderSpec c = *scene.cylinder;
        const double thinnest = std::min(2 * c.height, c.outer - c.inner);
        BodyPart part{Object::kCylinder, thinnest, std::hypot(c.outer, c.height), [c](Vec3 x, double) {
                          const double rho = std::hypot(x.x, x.y);
                          return std::max({rho - c.outer, c.inner - rho, std::abs(x.z) - c.height});
                      }};
        part.far = c.far, part.clear = true;
        parts_.push_back(part);
    }
    if (scene.ball) {
        const BallSpec b = *scene.ball;
        const auto way = ball_way(matter, b);
        double reach = length(b.position);
        if (b.motion != BallMotion::kStill)  // as far as it goes in the time that light takes
            for (int i = 0; i <= kWayLooks; ++i)
                reach = std::max(reach, length(way(scene.time - 4.0 * (scene.camera.r + 50.0) * i / kWayLooks)));
        const double step = b.motion == BallMotion::kStill ? 0.0 : b.radius;  // looks at its way were a step apart
        parts_.push_back({Object::kBall, b.radius, reach + b.radius + step,
                          [b, way](Vec3 x, double t) { return length(x - way(t)) - b.radius; }, b.far,
                          b.motion != BallMotion::kStill, way, b.motion != BallMotion::kPath});
    }
    if (scene.surface) {
        const auto shape = expr::Formula::parse(surface_shape(*scene.surface), {"x", "y", "z", "t"});
        const double bound = scene.surface->bound;
        if (shape)
            parts_.push_back({Object::kSurface, 2 * bound / scene.surface->steps, bound,
                              [f = *shape, bound](Vec3 x, double t) {
                                  const double place[] = {x.x, x.y, x.z, t};
                                  return std::max(f.value(place), length(x) - bound);
                              },
                              scene.surface->far, surface_moves(*scene.surface)});
    }
}

}  // namespace nullscope::reference
