#include "render/listed_start.h"

#include <cmath>

#include "render/frame_numbers.h"

namespace nullscope {

ListedStart::ListedStart(const FrameTables& tables)
    : tables_(tables), frame_(frame_numbers(tables.plan(), tables.path(), {}, tables.ball_paths())), flow_() {
    if (tables.matter().can_have_disc()) flow_.emplace(tables.matter());
}

RayNumbers ListedStart::numbers(double theta, double phi, Vec3 n, double at_angle) const {
    RayNumbers ray = tables_.path().ray_numbers(tables_.plan(), theta, phi, n);
    ray.meridian.w = at_angle;
    return ray;
}

double ListedStart::g(const RayNumbers& ray, const ListedRay::Crossing& met) const {
    const Vec3 u = disc_velocity(tables_.matter(), *flow_, std::hypot(met.x, met.y), {});
    return tables_.path().ray_g(tables_.plan(), frame_, ray, met, u);
}

}  // namespace nullscope
