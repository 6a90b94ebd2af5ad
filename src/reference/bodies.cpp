#include "reference/bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/tools/minima.hpp>

#include "expr/formula.h"
#include "reference/ball_way.h"
#include "reference/first_change.h"
#include "scene/moving.h"
#include "scene/named_surface.h"

namespace nullscope::reference {
namespace {

constexpr double kLongestTurn = 0.12;    // rad between two looks at an orbit
constexpr double kPartOfThinnest = 0.2;  // of a body's smallest extent between two looks, where it can be met
constexpr int kMostLooks = 200'000;
constexpr double kInPlane = 1e-9;  // of its radius: how far off the equatorial plane a ball's place may be written
constexpr int kWayLooks = 200;     // at the way of a ball

Vec3 place_at(const Orbit& orbit, const RayPlane& plane, double angle, bool by_length = false) {
    const double at = orbit.zeta_at(angle);
    return plane.direction(angle) * (by_length ? std::abs(at) : 1 / at);
}

// Radii at which looking is worth while: from the orbit's own extremes.
bool can_reach(const Orbit& orbit, double camera_r, double reach) {
    if (camera_r <= reach || orbit.fate() != Fate::kEscaped) return true;
    return std::isfinite(orbit.turn()) && orbit.turn() >= 1 / reach;
}

}  // namespace

Status check_bodies(const Scene& scene, const OrbitMetric& matter) {
    if (matter.spin() == 0 || !scene.ball) return Done{};
    const BallSpec& ball = *scene.ball;
    if (ball.motion == BallMotion::kGeodesic)
        return bad_input("ball.motion: falls are not followed about a spinning hole; allowed: still, orbit, path");
    if (ball.motion == BallMotion::kOrbit && std::abs(ball.position.z) > kInPlane * length(ball.position))
        return bad_input(
            "ball.position: orbits about a spinning hole that leave its equatorial plane are not followed; allowed: z "
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

Bodies::Bodies(const Scene& scene, const OrbitMetric& matter) : time_(scene.time) {
    const auto parts = moving_parts(scene);
    moves_ = std::any_of(parts.begin(), parts.end(),
                         [](const std::string& key) { return !key.starts_with("disc") && !key.starts_with("spot"); });
    if (scene.sphere) {
        const SphereSpec s = *scene.sphere;
        parts_.push_back(
            {Object::kSphere,
             s.radius * (1 - s.swing),
             s.radius * (1 + s.swing),
             [s](Vec3 x, double t) { return length(x) - s.radius * (1 + s.swing * std::sin(2 * M_PI * t / s.period)); },
             false,
             s.swing > 0,
             {},
             s.swing == 0});
    }
    if (scene.cylinder) {
        const CylinderSpec c = *scene.cylinder;
        const double thinnest = std::min(2 * c.height, c.outer - c.inner);
        parts_.push_back({Object::kCylinder,
                          thinnest,
                          std::hypot(c.outer, c.height),
                          [c](Vec3 x, double) {
                              const double rho = std::hypot(x.x, x.y);
                              return std::max({rho - c.outer, c.inner - rho, std::abs(x.z) - c.height});
                          },
                          c.far,
                          false,
                          {},
                          true});
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

double Bodies::time_at(double angle, const Part& part, LightClock* clock) const {
    return part.moves && clock != nullptr ? time_ - clock->late(angle) : time_;
}

// Equal looks along the path, fine where the body can be met; a change of sign is narrowed down by TOMS 748, a dip between three
// looks by Brent's minimisation.
std::optional<double> Bodies::first_angle(const Orbit& orbit, const RayPlane& plane, double camera_r, const Part& part,
                                          LightClock* clock) const {
    if (!can_reach(orbit, camera_r, part.reach * 1.001)) return std::nullopt;
    const auto value = [&](double angle) {
        return part.value(place_at(orbit, plane, angle), time_at(angle, part, clock));
    };
    const auto first_of = [&](double outside, double inside) { return first_change(value, outside, inside); };
    const double end = std::isfinite(orbit.angle()) ? orbit.angle() : std::numeric_limits<double>::infinity();
    double angle = 0, here = value(0), r = camera_r;
    double before_angle = 0, before = here;
    bool outward = false;
    for (int i = 0; i < kMostLooks; ++i) {
        // The stride in angle for a wanted stride in length, by the orbit's own change of radius over a tiny angle.
        const double probe = std::min(1e-6 * (1 + angle), 0.25 * (end - angle));
        const double r_probe = 1 / orbit.zeta_at(angle + probe);
        if (!(probe > 0) || !std::isfinite(r_probe)) return std::nullopt;
        const double speed = std::hypot((r_probe - r) / probe, r);  // length per angle
        outward = r_probe > r;
        const double fine = kPartOfThinnest * part.thinnest;
        if (outward && r > part.reach + 3 * fine) return std::nullopt;  // a look beyond every dip
        const double distance = std::max(r - part.reach, 0.0);
        const double stride = std::max(fine, 0.5 * distance);
        const double turn = std::min({std::min(stride, 0.2 * r) / speed, kLongestTurn, 0.5 * (end - angle)});
        const double next = angle + turn;
        if (!(next > angle) || end - next < 1e-13 * end) return std::nullopt;
        r = 1 / orbit.zeta_at(next);
        if (!std::isfinite(r)) return std::nullopt;
        const double there = value(next);
        if (here > 0 && there <= 0) return first_of(before_angle, next);
        if (here < before && here <= there && here > 0) {
            const auto [dip_angle, dip] = boost::math::tools::brent_find_minima(value, before_angle, next, 40);
            if (dip <= 0) return first_of(before_angle, dip_angle);
        }
        before_angle = angle, before = here;
        angle = next, here = there;
    }
    return std::nullopt;
}

std::optional<BodyHit> Bodies::first_hit(const Orbit& orbit, const RayPlane& plane, double camera_r, LightClock* clock,
                                         bool by_length) const {
    std::optional<BodyHit> first;
    for (const Part& part : parts_) {
        const auto angle = by_length ? first_angle_by_length(orbit, plane, camera_r, part)
                                     : first_angle(orbit, plane, camera_r, part, clock);
        if (!angle || (first && first->along <= *angle)) continue;
        const Vec3 place = place_at(orbit, plane, *angle, by_length);
        const double turn = 1e-6;
        const Vec3 earlier =
            *angle > turn ? place_at(orbit, plane, *angle - turn, by_length) : place_at(orbit, plane, 0, by_length);
        const double t = time_at(*angle, part, clock);
        first = BodyHit{*angle, place, part.object, part.cosine(place, earlier - place, t),
                        part.middle ? part.middle(t) : Vec3{0, 0, 0}};
    }
    return first;
}

}  // namespace nullscope::reference
