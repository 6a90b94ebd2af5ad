#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "reference/bodies.h"
#include "reference/disc_light.h"
#include "reference/metric.h"
#include "reference/plane_ray.h"
#include "reference/reference.h"
#include "scene/disc_shape.h"
#include "scene/leaning_disc.h"

namespace nullscope::reference {
namespace {

// A unit vector without overflow, or an error.
Result<Vec3> unit_direction(Vec3 n) {
    const double largest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
    if (!std::isfinite(n.x) || !std::isfinite(n.y) || !std::isfinite(n.z))
        return bad_input("the view direction must be finite");
    if (largest == 0) return bad_input("the view direction must not be zero");
    return normalized(n / largest);
}

}  // namespace

Result<RayRecord> trace_ray(const Scene& scene, const RayQuery& query, int crossings, const DiscLight* matter) {
    TRY(metric, make_metric(scene.spacetime));
    if (query.at_angle && !(*query.at_angle >= 0 && std::isfinite(*query.at_angle)))
        return bad_input(fmt::format("at_angle = {} must be finite and not negative", *query.at_angle));
    RayQuery asked = query;
    if (!query.orbit) {
        TRY(n, unit_direction(query.n));
        asked.n = *n;
    }
    if (Status followed = check_bodies(scene, **metric); !followed) return followed.error();
    const Bodies bodies(scene, **metric);
    RayTask task{&bodies, scene.light.delay, false, crossings};
    task.plane = disc_plane_of(scene);
    const auto shape = disc_shape_of(scene);
    if (shape) task.shape = &*shape;
    TRY(traced, (*metric)->ray(asked, task));
    const TracedRay& ray = **traced;
    const auto hit = ray.first_hit();
    RayRecord record;
    record.fate = hit ? Fate::kHit : ray.fate();
    record.hit = hit ? hit->number : record.fate == Fate::kHit ? kStarHit : 0;
    record.angle = ray.swept(hit ? hit->along : ray.end());
    record.g = ray.g;
    if (!hit) record.delay = ray.delay();
    if (record.fate == Fate::kEscaped || record.fate == Fate::kOtherSide) {
        record.sky = ray.end_direction();
        record.theta_inf = std::atan2(std::hypot(record.sky.x, record.sky.y), record.sky.z);
        record.phi_inf = ray.end_azimuth();
    }
    if (const PlaneRay* plane = ray.in_plane()) {
        record.turn = plane->orbit().turn();
        if (query.at_angle) record.at = plane->orbit().zeta_at(*query.at_angle);
    }
    const double horizon = (*metric)->horizon_radius().value_or(0.0);
    for (const PlaneCrossing& c : ray.crossings(crossings)) {
        if (hit && c.along > hit->along) break;
        const bool shines = matter && c.r > horizon;
        record.crossings.push_back(
            {c.r, c.phi, shines ? ray.g * matter->g_infinity({c.r, c.l, c.climb, c.cosine, c.across}) : kNotANumber});
    }
    return record;
}

}  // namespace nullscope::reference
