// A ray that stays in a plane, as one stretch (ray_stretch.h): places by its closed form, rates by its first integrals.
#pragma once
#include <optional>

#include "reference/plane_ray.h"
#include "reference/ray_stretch.h"
#include "spacetime/spacetime.h"

namespace nullscope::reference {

// Along it is the swept angle, of a radial ray the way along the radius.
struct PlaneStretch {
    RayStretch stretch;
    double last;  // along, where the ray ends; infinite where it reaches a sky or a horizon
};
// query: the ray's; its n is a unit vector. hit_angle, hit_r: where something on its way ends it, else infinite. Nothing: it ends nowhere, or has no positive
// energy. ray, spacetime: outlive it.
std::optional<PlaneStretch> plane_stretch(const PlaneRay& ray, const RayQuery& query, const Spacetime& spacetime,
                                          double hit_angle, double hit_r);

}  // namespace nullscope::reference
