// Bodies in a wormhole: orbits give l, of either sign, and a body stands on one side.
#include <algorithm>
#include <cmath>

#include "reference/first_change.h"
#include "reference/plane_bodies.h"

namespace nullscope::reference {
namespace {

constexpr double kLongestTurn = 0.1;  // rad between two looks
constexpr double kPartOfThinnest =
    0.15;                           // of a body's smallest extent between two looks on its side, where it can be met
constexpr double kPartOfWay = 0.4;  // of the way to where it can be met, elsewhere
constexpr int kMostLooks = 200'000;

}  // namespace

// Looks at most a stride apart in the coordinates of the sides, in which the throat is the origin of both: a turn is halved until it is
// no longer than that, and the next one starts with its double.
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
    const double fine = kPartOfThinnest * part.thinnest, rim = part.reach + 3 * fine;
    double angle = 0, l = camera_l, here = value_at(0, l), before_angle = 0, before = here,
           turn = 0.25 * std::min(end, kLongestTurn);
    for (int i = 0; i < kMostLooks; ++i) {
        const double from_body = l * own > 0 ? std::max(std::abs(l) - part.reach, 0.0) : std::abs(l),
                     stride = std::max(fine, kPartOfWay * from_body);
        turn = std::min({2 * turn, kLongestTurn, 0.5 * (end - angle)});
        double next = angle + turn, there_l = orbit.zeta_at(next);
        const auto way = [&] {
            const Vec3 moved = plane.direction(next) * there_l -
                               plane.direction(angle) * l;  // through the origin where l changes sign
            return std::hypot(length(moved), there_l * l < 0 ? std::abs(there_l) + std::abs(l) : 0.0);
        };
        while (std::isfinite(there_l) && way() > stride)
            turn *= 0.5, next = angle + turn, there_l = orbit.zeta_at(next);
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
