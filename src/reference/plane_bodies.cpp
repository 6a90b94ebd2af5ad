#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/first_change.h"
#include "reference/plane_ray.h"

namespace nullscope::reference {
namespace {

constexpr double kLongestTurn = 0.12;    // rad between two looks at an orbit
constexpr double kPartOfThinnest = 0.2;  // of a body's smallest extent between two looks, where it can be met
// In wormholes these two, and the part of the distance to where it can be met, elsewhere.
constexpr double kThroatTurn = 0.1, kThroatPart = 0.15, kPartOfDistance = 0.4;
constexpr int kMostSamples = 200'000;
// Of a body's distance: what a sample may go towards it. The rest is for how the ray bends and its length changes within a look.
constexpr double kPartOfClear = 0.7;
constexpr double kLongestPart = 0.2;  // of the radius, that a sample may go

// How far along the ray a body is at least whose distance is known: one that moves comes to meet it, while light's time runs up to 1/A as
// fast as its way.
double clear_way(const PlaneRay& ray, const BodyPart& part, double value, double r) {
    if (!std::isfinite(part.speed)) return 0;
    if (!part.moves) return kPartOfClear * value;
    const double a = ray.metric().lapse2((1 - kLongestPart) * r);
    return a > 0 ? kPartOfClear * value / (1 + part.speed / a) : 0;
}

// Radii at which looking is worth while: from the orbit's own extremes.
bool can_reach(const Orbit& orbit, double camera_r, double reach) {
    if (camera_r <= reach || orbit.fate() != Fate::kEscaped) return true;
    return std::isfinite(orbit.turn()) && orbit.turn() >= 1 / reach;
}

// Whether two looks, `chord` apart, show that a body whose distance is known is not met between them.
bool is_clear(const PlaneRay& ray, const BodyPart& part, const Look& a, const Look& b, double r, double chord) {
    return clear_way(ray, part, a.value + b.value, r) >= chord;
}

bool dips(const Look& before, const Look& here, const Look& there) {
    return here.value < before.value && here.value <= there.value;
}

}  // namespace

// Equal looks along the path, fine where the body can be met; a change of sign is narrowed down by TOMS 748, a dip
// between three looks by Brent's minimisation: both of the orbit itself.
std::optional<double> entry(const PlaneRay& ray, const BodyPart& part, const std::function<double(double)>& time_at,
                            OrbitPlaces& places) {
    const Orbit& orbit = ray.orbit();
    if (!can_reach(orbit, ray.photon().r, part.reach * 1.001)) return std::nullopt;
    const auto value = [&](double angle) { return part.value(ray.place_at(angle), time_at(angle)); };
    const double end = std::isfinite(orbit.angle()) ? orbit.angle() : std::numeric_limits<double>::infinity();
    double r = ray.photon().r;
    Look here{0, value(0)}, before = here;
    Vec3 place = ray.place_at(0);
    bool outward = false, clear_before = false;
    for (int i = 0; i < kMostSamples; ++i) {
        // The step in angle for a wanted step in length, by the orbit's own change of radius over a tiny angle.
        const double angle = here.along, probe = std::min(1e-6 * (1 + angle), 0.25 * (end - angle));
        const double r_probe = 1 / places(angle + probe);
        if (!(probe > 0) || !std::isfinite(r_probe)) return std::nullopt;
        const double speed = std::hypot((r_probe - r) / probe, r);  // length per angle
        outward = r_probe > r;
        const double fine = kPartOfThinnest * part.thinnest;
        if (outward && r > part.reach + 3 * fine) return std::nullopt;  // a sample beyond every dip
        const double distance = std::max(r - part.reach, 0.0);
        const double step = std::max({fine, 0.5 * distance, clear_way(ray, part, here.value, r)});
        const double turn = std::min({std::min(step, kLongestPart * r) / speed, kLongestTurn, 0.5 * (end - angle)});
        const double next = angle + turn;
        if (!(next > angle) || end - next < 1e-13 * end) return std::nullopt;
        const double r_here = std::exchange(r, 1 / places(next));
        if (!std::isfinite(r)) return std::nullopt;
        const Vec3 place_here = std::exchange(place, ray.plane().direction(next) * r);
        Look there{next, part.value(place, time_at(next))};
        const bool clear = is_clear(ray, part, here, there, std::min(r, r_here), length(place - place_here));
        if (there.value <= 0 || (dips(before, here, there) && !(clear_before && clear))) {
            there.value = value(next);
            if (const auto entered = entry_between(value, before, {angle, value(angle)}, there)) return entered;
        }
        before = here, here = there, clear_before = clear;
    }
    return std::nullopt;
}

// Looks at most a step apart in the coordinates of the sides, in which the throat is the origin of both: a turn is
// halved until it is no longer than that, and the next one starts with its double.
std::optional<double> entry_by_length(const PlaneRay& ray, const BodyPart& part, double time, OrbitPlaces& places) {
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
    double l = camera_l, turn = 0.25 * std::min(end, kThroatTurn);
    Look here{0, value_at(0, l)}, before = here;
    for (int i = 0; i < kMostSamples; ++i) {
        const double angle = here.along,
                     from_body = l * own > 0 ? std::max(std::abs(l) - part.reach, 0.0) : std::abs(l),
                     step = std::max(fine, kPartOfDistance * from_body);
        turn = std::min({2 * turn, kThroatTurn, 0.5 * (end - angle)});
        double next = angle + turn, there_l = places(next);
        const Vec3 place = plane.direction(angle) * l;
        const auto way = [&] {
            const Vec3 moved = plane.direction(next) * there_l - place;  // through the origin where l changes sign
            return std::hypot(length(moved), there_l * l < 0 ? std::abs(there_l) + std::abs(l) : 0.0);
        };
        while (std::isfinite(there_l) && way() > step) turn *= 0.5, next = angle + turn, there_l = places(next);
        if (!std::isfinite(there_l) || !(next > angle)) return std::nullopt;
        Look there{next, value_at(next, there_l)};
        if (there.value <= 0 || dips(before, here, there)) {
            there.value = value(next);
            if (const auto entered = entry_between(value, before, {angle, value(angle)}, there)) return entered;
        }
        // Outward on the side where the ray ends it does not come back.
        const bool leaves = there_l * ends > 0 && std::abs(there_l) > std::abs(l) && l * ends > 0;
        if (leaves && (own != ends || std::abs(l) > rim)) return std::nullopt;
        before = here, here = there, l = there_l;
    }
    return std::nullopt;
}

}  // namespace nullscope::reference
