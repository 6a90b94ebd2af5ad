#include "reference/plane_stretch.h"

#include <algorithm>
#include <cmath>

namespace nullscope::reference {
namespace {

constexpr double kRadialImpact = 1e-10;   // of L/E, r_s, below which the angle is of no use
constexpr double kLongestSweep = 0.4;     // of a piece, rad
constexpr double kBeforeSurface = 1e-15;  // of the angle to a star's surface, where the orbit has ended
constexpr double kStraightScale = 0.5;    // r_s: what a straight way through the centre is smooth over
constexpr double kSenseStep = 1e-6;       // of an angle, for the sense of the radius

// Of the metric at a radius: ds^2 = -a dt^2 + b dr^2 + across^2 dOmega^2.
struct Radial {
    double a, b, across;
    Radial(const Spacetime& spacetime, double r) {
        const Matrix4 g = spacetime.metric(r, M_PI / 2);
        a = -g[0][0], b = g[1][1], across = std::sqrt(g[3][3]);
    }
};

double polar(const Vec3& n) { return std::atan2(std::hypot(n.x, n.y), n.z); }

// L/E of a camera at rest: of metrics whose r is not the areal radius too.
double impact(const PlaneRay& ray, const RayQuery& query, const Spacetime& spacetime, bool falls) {
    if (query.orbit) return 1 / query.orbit->q;
    if (falls) return ray.photon().l;
    const Radial here(spacetime, query.r);
    return here.across * std::hypot(query.n.y, query.n.z) / std::sqrt(here.a);
}

// Towards growing r, or l: 1, or towards falling: -1.
double sense_at(const PlaneRay& ray, double angle) {
    const auto difference = [&](double at) {
        const double off = std::max(kSenseStep * at, kSenseStep * kSenseStep), low = std::max(at - off, 0.0);
        const double high = at + off < ray.end() ? at + off : at;
        return std::copysign(1.0, ray.radius_at(high) - ray.radius_at(low));
    };
    const double turn = ray.orbit().turn_angle();
    if (std::isnan(turn)) return difference(angle);
    return (angle < turn ? 1 : -1) * difference(0.5 * turn);
}

RayStretch swept_stretch(const PlaneRay& ray, const Spacetime& spacetime, double l, bool timed) {
    const auto at = [&ray, &spacetime, l, timed](double angle) {
        const double r = ray.radius_at(angle);
        const Radial here(spacetime, r);
        const double rate = here.across * here.across / l;
        return StretchPlace{r,
                            polar(ray.plane().direction(angle)),
                            ray.plane().azimuth(angle),
                            here.across,
                            timed ? here.a : 1,
                            rate,
                            1,
                            0,
                            timed ? -rate / here.a : kNotANumber,
                            here.across * here.across};
    };
    const auto motion = [&ray, &spacetime, l, timed](double angle) {
        const Radial here(spacetime, ray.radius_at(angle));
        const Vec3 n = ray.plane().direction(angle), across = ray.plane().direction(angle + M_PI / 2);
        const double turn = l / (here.across * here.across), flat2 = n.x * n.x + n.y * n.y;
        const double square = (1 / here.a - l * turn) / here.b;  // of dr by the affine parameter
        return StretchMotion{sense_at(ray, angle) * std::sqrt(std::max(square, 0.0)),
                             flat2 > 0 ? -turn * across.z / std::sqrt(flat2) : turn,
                             flat2 > 0 ? turn * (n.x * across.y - n.y * across.x) / flat2 : 0,
                             timed ? -1 / here.a : kNotANumber};
    };
    return {0, ray.end(), kLongestSweep, at, motion};
}

// In or out along the radius; in flat space through the centre, where r would be negative.
RayStretch radial_stretch(const PlaneRay& ray, const Spacetime& spacetime, double sense, bool timed) {
    const double r0 = ray.photon().r;
    const bool through = !spacetime.bends_light() && !spacetime.by_proper_length();
    const auto place_of = [r0, sense, through](double along) {
        const double r = r0 + sense * along;
        return through ? std::abs(r) : r;
    };
    const auto at = [=, &ray, &spacetime](double along) {
        const double r = place_of(along);
        const Radial here(spacetime, r);
        const bool beyond = through && r0 + sense * along < 0;
        const Vec3 n = beyond ? -ray.plane().direction(0) : ray.plane().direction(0);
        const double rate = std::sqrt(here.a * here.b);
        return StretchPlace{r,
                            polar(n),
                            ray.plane().azimuth(0) + (beyond ? M_PI : 0),
                            through ? std::hypot(r, kStraightScale) : here.across,
                            timed ? here.a : 1,
                            rate,
                            0,
                            0,
                            timed ? -rate / here.a : kNotANumber,
                            here.across * here.across};
    };
    const auto motion = [=, &spacetime](double along) {
        const Radial here(spacetime, place_of(along));
        const double back = through && r0 + sense * along < 0 ? -1 : 1;
        return StretchMotion{back * sense / std::sqrt(here.a * here.b), 0, 0, timed ? -1 / here.a : kNotANumber};
    };
    return {0, kNowhere, kNowhere, at, motion};
}

}  // namespace

std::optional<PlaneStretch> plane_stretch(const PlaneRay& ray, const RayQuery& query, const Spacetime& spacetime,
                                          double hit_angle, double hit_r) {
    const double r0 = ray.photon().r, horizon = spacetime.horizon_radius().value_or(-kNowhere);
    const bool rain = !query.orbit && query.frame == LocalFrame::kRain && std::isfinite(horizon);
    const double l = impact(ray, query, spacetime, rain);
    const bool timed = r0 > horizon;
    if (!std::isfinite(l)) return {};
    if (l < kRadialImpact) {
        const double sense = query.orbit ? -query.orbit->s * (r0 < 0 ? -1.0 : 1.0) : std::copysign(1.0, query.n.x);
        double last = hit_r < kNowhere ? std::abs(r0 - hit_r) : kNowhere;
        const bool bare = !std::isfinite(horizon) && !spacetime.by_proper_length() && spacetime.bends_light();
        if (sense < 0 && bare) {
            if (!spacetime.surface_radius()) return {};
            last = std::min(last, r0 - *spacetime.surface_radius());
        }
        if (!timed && sense < 0) return {};
        return PlaneStretch{radial_stretch(ray, spacetime, sense, timed), last};
    }
    if (!std::isfinite(ray.end()) && !std::isfinite(hit_angle)) return {};
    RayStretch stretch = swept_stretch(ray, spacetime, l, timed);
    const bool ends = ray.fate() == Fate::kHit;
    const double last = std::min(hit_angle, ends ? ray.end() * (1 - kBeforeSurface) : kNowhere);
    if (std::isnan(stretch.to)) stretch.to = hit_angle;
    return PlaneStretch{std::move(stretch), last};
}

}  // namespace nullscope::reference
