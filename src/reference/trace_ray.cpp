#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "reference/bodies.h"
#include "reference/disc_light.h"
#include "reference/kerr_ray.h"
#include "reference/orbit.h"
#include "reference/ray_plane.h"
#include "reference/reference.h"
#include "reference/spin_bodies.h"

namespace nullscope::reference {
namespace {

// Outside of these the squares of the orbit equation would leave the range of a double.
constexpr double kLeastRadius = 1e-30, kLargestRadius = 1e60;

struct Traced {
    std::unique_ptr<Orbit> orbit;
    double g;
};

Result<Traced> trace_reduced(const OrbitMetric& metric, const ReducedRay& ray) {
    if (!(ray.q > 0)) return bad_input(fmt::format("q = {} must be positive (infinite for a radial ray)", ray.q));
    if (metric.by_proper_length() && !(std::abs(ray.zeta0) <= kLargestRadius))
        return bad_input(fmt::format("l0 = {} must lie in [{}, {}]", ray.zeta0, -kLargestRadius, kLargestRadius));
    if (!metric.by_proper_length() && !(ray.zeta0 >= 1 / kLargestRadius && ray.zeta0 <= 1 / kLeastRadius)) {
        return bad_input(
            fmt::format("zeta0 = {} must lie in [{}, {}]", ray.zeta0, 1 / kLargestRadius, 1 / kLeastRadius));
    }
    if (ray.s != 1 && ray.s != -1) return bad_input(fmt::format("s = {} must be 1 (towards the hole) or -1", ray.s));
    auto orbit = metric.from_reduced(ray);
    if (!orbit) return orbit.error();
    const double lapse = metric.lapse(metric.by_proper_length() ? ray.zeta0 : 1 / ray.zeta0);
    return Traced{std::move(*orbit), lapse > 0 ? 1 / lapse : kNotANumber};
}

// query.n is a unit vector here.
Result<Traced> trace_local(const OrbitMetric& metric, const RayQuery& query, Vec3 n) {
    const double least = metric.by_proper_length() ? -kLargestRadius : kLeastRadius;
    if (!(query.r >= least && query.r <= kLargestRadius)) {
        return bad_input(fmt::format("r = {} must lie in [{}, {}]", query.r, least, kLargestRadius));
    }
    if (!(query.theta >= 0 && query.theta <= M_PI))
        return bad_input(fmt::format("theta = {} must lie in [0, pi]", query.theta));
    if (!std::isfinite(query.phi)) return bad_input("phi must be finite");
    const LocalRay ray{query.r, n.x, std::hypot(n.y, n.z)};
    if (query.frame == LocalFrame::kRain) {
        RainOrbit rain = metric.from_rain(ray);
        return Traced{std::move(rain.orbit), rain.g};
    }
    if (metric.horizon_radius() && !(query.r > *metric.horizon_radius())) {
        return bad_input(
            fmt::format("no static frame at r = {}: it needs r > {}, the horizon (use frame = rain inside)", query.r,
                        *metric.horizon_radius()));
    }
    return Traced{metric.from_static(ray), 1 / metric.lapse(query.r)};
}

// A unit vector without overflow, or an error.
Result<Vec3> unit_direction(Vec3 n) {
    const double largest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
    if (!std::isfinite(n.x) || !std::isfinite(n.y) || !std::isfinite(n.z))
        return bad_input("the look direction must be finite");
    if (largest == 0) return bad_input("the look direction must not be zero");
    return normalized(n / largest);
}

void list_crossings(const Orbit& orbit, bool by_proper_length, const RayPlane& plane, int count,
                    std::vector<RayRecord::Crossing>& list) {
    for (int k = 1; k <= count; ++k) {
        const double angle = plane.crossing(k);
        if (!(angle < orbit.angle())) return;
        const double place = orbit.zeta_at(angle);
        list.push_back({by_proper_length ? place : 1 / place, plane.azimuth(angle)});
    }
}

// Ends the ray on the first solid body; what was along it before stays.
void stop_at_bodies(const Scene& scene, const OrbitMetric& metric, const Orbit& orbit, const RayPlane& plane, double r,
                    LightClock* clock, bool by_length, RayRecord& record) {
    const Bodies bodies(scene, metric);
    if (bodies.empty()) return;
    const auto hit = bodies.first_hit(orbit, plane, r, clock, by_length);
    if (!hit) return;
    record.fate = Fate::kHit;
    record.hit = hit->object;
    record.angle = hit->along;
    record.theta_inf = record.phi_inf = record.delay = kNotANumber;
    record.sky = {kNotANumber, kNotANumber, kNotANumber};
    for (std::size_t k = 0; k < record.crossings.size(); ++k)
        if (plane.crossing(static_cast<int>(k) + 1) > hit->along) record.crossings.resize(k);
}

// The photon moves against n: L over E is -g r n_phi about the camera's place, and on to the axis.
void shift_crossings(const DiscLight& matter, const OrbitMetric& metric, const Orbit& orbit, const RayPlane& plane,
                     const RayQuery& query, Vec3 n, RayRecord& record) {
    const double scale = record.g * query.r, l = scale * std::hypot(n.y, n.z),
                 l_z = -scale * n.z * std::sin(query.theta);
    for (std::size_t k = 0; k < record.crossings.size(); ++k) {
        RayRecord::Crossing& c = record.crossings[k];
        if (!(c.r > metric.horizon_radius().value_or(0.0))) continue;
        const bool outward =
            orbit.zeta_at(plane.crossing(static_cast<int>(k) + 1) * (1 - 1e-6)) < 1 / c.r;  // traced inward
        c.g = record.g * matter.g_infinity({c.r, l_z, outward, l * l});
    }
}

Result<RayRecord> trace_spinning(const Scene& scene, const OrbitMetric& metric, const RayQuery& query, int crossings,
                                 const DiscLight* matter) {
    if (query.orbit) return metric.from_reduced(*query.orbit).error();
    if (query.frame == LocalFrame::kRain) return bad_input("no frame = rain about a spinning hole; allowed: static");
    const double horizon = *metric.horizon_radius();
    if (!(query.r > horizon && query.r <= kLargestRadius))
        return bad_input(
            fmt::format("r = {} must lie in ({}, {}], outside the horizon", query.r, horizon, kLargestRadius));
    if (!(query.theta >= 0 && query.theta <= M_PI && std::isfinite(query.phi)))
        return bad_input(fmt::format("theta = {} must lie in [0, pi] and phi = {} be finite", query.theta, query.phi));
    const auto n = unit_direction(query.n);
    if (!n) return n.error();
    if (Status followed = check_bodies(scene, metric); !followed) return followed.error();
    const Bodies bodies(scene, metric);
    BodyWatch bodies_on(bodies, scene.light.delay);
    const KerrRay ray = trace_kerr(metric.spin(), {query.r, query.theta, query.phi, *n}, crossings, bodies_on.watch());
    const auto& hit = bodies_on.hit();
    RayRecord record;
    record.fate = hit ? Fate::kHit : ray.fate;
    if (hit) record.hit = hit->object;
    record.g = 1 / ray.energy;
    for (const KerrRay::Crossing& c : ray.crossings) {
        if (hit && c.along > hit->along) break;
        const double g =
            matter ? record.g * matter->g_infinity({c.r, ray.l_z, c.radial > 0, kNotANumber, c.radial}) : kNotANumber;
        record.crossings.push_back({c.r, c.phi, g});
    }
    if (record.fate != Fate::kEscaped) return record;
    record.sky = ray.sky;
    record.delay = ray.delay;
    record.theta_inf = std::atan2(std::hypot(ray.sky.x, ray.sky.y), ray.sky.z);
    record.phi_inf = ray.phi_inf;
    return record;
}

}  // namespace

Result<RayRecord> trace_ray(const Scene& scene, const RayQuery& query, int crossings, const DiscLight* matter) {
    auto metric = make_orbit_metric(scene.spacetime);
    if (!metric) return metric.error();
    if (query.at_angle && !(*query.at_angle >= 0 && std::isfinite(*query.at_angle))) {
        return bad_input(fmt::format("at_angle = {} must be finite and not negative", *query.at_angle));
    }
    if ((*metric)->spin() != 0) return trace_spinning(scene, **metric, query, crossings, matter);
    Vec3 n{0, 0, 1};  // of the reduced form: in the equatorial plane towards growing phi
    double theta = M_PI / 2, phi = 0;
    if (!query.orbit) {
        auto unit = unit_direction(query.n);
        if (!unit) return unit.error();
        n = *unit;
        theta = query.theta;
        phi = query.phi;
    }
    auto traced = query.orbit ? trace_reduced(**metric, *query.orbit) : trace_local(**metric, query, n);
    if (!traced) return traced.error();
    const Orbit& orbit = *traced->orbit;
    const RayPlane plane(theta, phi, n);
    RayRecord record;
    record.fate = orbit.fate();
    record.angle = orbit.angle();
    record.turn = orbit.turn();
    record.g = traced->g;
    record.delay = orbit.delay();
    if (query.at_angle) record.at = orbit.zeta_at(*query.at_angle);
    if (record.fate == Fate::kEscaped || record.fate == Fate::kOtherSide) {
        record.sky = plane.direction(record.angle);
        record.theta_inf = std::atan2(std::hypot(record.sky.x, record.sky.y), record.sky.z);
        record.phi_inf = plane.azimuth(record.angle);
    }
    if (record.fate == Fate::kHit) record.hit = Object::kStar;
    list_crossings(orbit, (*metric)->by_proper_length(), plane, crossings, record.crossings);
    if (matter && !query.orbit) shift_crossings(*matter, **metric, orbit, plane, query, n, record);
    const bool by_length = (*metric)->by_proper_length();
    const double r = !query.orbit ? query.r : by_length ? query.orbit->zeta0 : 1 / query.orbit->zeta0;
    const double q = query.orbit ? query.orbit->q : 1 / (traced->g * r * std::hypot(n.y, n.z));
    LightClock clock(**metric, orbit, q, r, !query.orbit && query.frame == LocalFrame::kRain);
    stop_at_bodies(scene, **metric, orbit, plane, r, scene.light.delay && !by_length ? &clock : nullptr, by_length,
                   record);
    return record;
}

}  // namespace nullscope::reference
