#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/first_change.h"
#include "reference/plane_ray.h"

namespace nullscope::reference {
namespace {

constexpr double kLongestTurn = 0.12;    // rad between two looks at an orbit
constexpr double kPartOfThinnest = 0.2;  // of a body's smallest extent between two looks, where it can be met
// In wormholes these two, and the part of the distance to where it can be met, elsewhere.
constexpr double kThroatTurn = 0.1, kThroatPart = 0.15, kPartOfDistance = 0.4;
constexpr int kMostLooks = 200'000;

// Radii at which looking is worth while: from the orbit's own extremes.
bool can_reach(const Orbit& orbit, double camera_r, double reach) {
    if (camera_r <= reach || orbit.fate() != Fate::kEscaped) return true;
    return std::isfinite(orbit.turn()) && orbit.turn() >= 1 / reach;
}

}  // namespace

// Equal looks along the path, fine where the body can be met; a change of sign is narrowed down by TOMS 748, a dip
// between three looks by Brent's minimisation.
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

// Looks at most a step apart in the coordinates of the sides, in which the throat is the origin of both: a turn is
// halved until it is no longer than that, and the next one starts with its double.
std::optional<double> entry_by_length(const PlaneRay& ray, const BodyPart& part, double time) {
    const Orbit& orbit = ray.orbit();
    const RayPlane& plane = ray.plane();
    const double camera_l = ray.photon().r;
    const double own = part.far ? -1 : 1, ends = orbit.fate() == Fate::kOtherSide ? -1 : 1, end = orbit.angle();
    if (!(end > 0) || ((camera_l < 0 ? -1 : 1) != own && ends != own)) return std::nullopt;  // never on that side
    const double throat = part.value({0, 0, 0}, time);
    const auto value_at = [&](double angle, double l) {
        return l * own > 0 ? part.value(plane.direction(angle) * std::abs(l), time) : throat + std::abs(l);
    };
    const auto value = [&](double angle) { return value_at(angle, orbit.zeta_at(angle)); };
    const double fine = kThroatPart * part.thinnest, rim = part.reach + 3 * fine;
    double angle = 0, l = camera_l, here = value_at(0, l), before_angle = 0, before = here,
           turn = 0.25 * std::min(end, kThroatTurn);
    for (int i = 0; i < kMostLooks; ++i) {
        const double from_body = l * own > 0 ? std::max(std::abs(l) - part.reach, 0.0) : std::abs(l),
                     step = std::max(fine, kPartOfDistance * from_body);
        turn = std::min({2 * turn, kThroatTurn, 0.5 * (end - angle)});
        double next = angle + turn, there_l = orbit.zeta_at(next);
        const auto way = [&] {
            const Vec3 moved = plane.direction(next) * there_l -
                               plane.direction(angle) * l;  // through the origin where l changes sign
            return std::hypot(length(moved), there_l * l < 0 ? std::abs(there_l) + std::abs(l) : 0.0);
        };
        while (std::isfinite(there_l) && way() > step) turn *= 0.5, next = angle + turn, there_l = orbit.zeta_at(next);
        if (!std::isfinite(there_l) || !(next > angle)) return std::nullopt;
        const double there = value_at(next, there_l);
        if (here > 0 && there <= 0) return first_change(value, before_angle, next);
        if (here < before && here <= there && here > 0) {
            const auto [dip_angle, dip] = boost::math::tools::brent_find_minima(value, before_angle, next, 40);
            if (dip <= 0) return first_change(value, before_angle, dip_angle);
        }
        // Outward on the side where the ray ends it does not come back.
        const bool leaves = there_l * ends > 0 && std::abs(there_l) > std::abs(l) && l * ends > 0;
        if (leaves && (own != ends || std::abs(l) > rim)) return std::nullopt;
        before_angle = angle, before = here;
        angle = next, l = there_l, here = there;
    }
    return std::nullopt;
}

}  // namespace nullscope::reference
