#include "reference/plane_bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/first_change.h"

namespace nullscope::reference {
namespace {

constexpr double kLongestTurn = 0.12;    // rad between two looks at an orbit
constexpr double kPartOfThinnest = 0.2;  // of a body's smallest extent between two looks, where it can be met
constexpr int kMostLooks = 200'000;

// Radii at which looking is worth while: from the orbit's own extremes.
bool can_reach(const Orbit& orbit, double camera_r, double reach) {
    if (camera_r <= reach || orbit.fate() != Fate::kEscaped) return true;
    return std::isfinite(orbit.turn()) && orbit.turn() >= 1 / reach;
}

}  // namespace

// Equal looks along the path, fine where the body can be met; a change of sign is narrowed down by TOMS 748, a dip between three
// looks by Brent's minimisation.
std::optional<double> entry(const PlaneRay& ray, const BodyPart& part, const std::function<double(double)>& time_at) {
    const Orbit& orbit = ray.orbit();
    if (!can_reach(orbit, ray.photon().r, part.reach * 1.001)) return std::nullopt;
    const auto value = [&](double angle) { return part.value(ray.place_at(angle), time_at(angle)); };
    const auto first_of = [&](double outside, double inside) { return first_change(value, outside, inside); };
    const double end = std::isfinite(orbit.angle()) ? orbit.angle() : std::numeric_limits<double>::infinity();
    double angle = 0, here = value(0), r = ray.photon().r;
    double before_angle = 0, before = here;
    bool outward = false;
    for (int i = 0; i < kMostLooks; ++i) {
        // The step in angle for a wanted step in length, by the orbit's own change of radius over a tiny angle.
        const double probe = std::min(1e-6 * (1 + angle), 0.25 * (end - angle));
        const double r_probe = 1 / orbit.zeta_at(angle + probe);
        if (!(probe > 0) || !std::isfinite(r_probe)) return std::nullopt;
        const double speed = std::hypot((r_probe - r) / probe, r);  // length per angle
        outward = r_probe > r;
        const double fine = kPartOfThinnest * part.thinnest;
        if (outward && r > part.reach + 3 * fine) return std::nullopt;  // a look beyond every dip
        const double distance = std::max(r - part.reach, 0.0);
        const double step = std::max(fine, 0.5 * distance);
        const double turn = std::min({std::min(step, 0.2 * r) / speed, kLongestTurn, 0.5 * (end - angle)});
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

}  // namespace nullscope::reference
