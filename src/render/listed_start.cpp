#include "render/listed_start.h"

#include <cmath>

#include "render/frame_numbers.h"
#include "scene/leaning_disc.h"
#include "spacetime/axial_metric.h"
#include "spacetime/leaning_circle.h"

namespace nullscope {

ListedStart::ListedStart(const FrameTables& tables, Sense sense)
    : tables_(tables),
      sense_(sense),
      frame_(frame_numbers(tables.plan(), tables.path(), {}, tables.ball_paths())),
      flow_() {
    if (tables.matter().can_have_disc()) flow_.emplace(tables.matter(), sense);
    CameraSpec camera = tables.plan().scene.camera;
    camera.yaw = camera.pitch = camera.roll = 0.0;
    screen_ = screen_form(tables.matter(), camera, tables.plan().observer, true);
}

RayNumbers ListedStart::numbers(double theta, double phi, Vec3 n, double at_angle) const {
    RayNumbers ray = tables_.path().ray_numbers(tables_.plan(), theta, phi, n);
    ray.meridian.w = at_angle;
    return ray;
}

Vec3 ListedStart::velocity(const ListedRay::Crossing& met) const {
    const double r = std::hypot(met.x, met.y);
    const Spacetime& matter = tables_.matter();
    if (!tables_.effects().contains(Effect::kDiscLean)) return disc_velocity(matter, *flow_, r, {});
    const double tilt = tables_.plan().scene.disc->lean.tilt,
                 rate = leaning_rate(matter, r, sense_, tilt).value_or(NAN),
                 height = disc_plane_of(tables_.plan().scene).place(met.x, met.y).z / r;
    const double lapse2 = leaning_lapse2(matter, r, rate, tilt, std::sqrt(std::fmax(1.0 - height * height, 0.0))),
                 u_t = 1.0 / std::sqrt(lapse2);  // not a number where that outruns light
    return {u_t, rate * u_t, 0.0};
}

double ListedStart::g(const RayNumbers& ray, const ListedRay::Crossing& met) const {
    const Vec3 u = velocity(met);
    return tables_.path().ray_g(tables_.plan(), frame_, ray, met, u);
}

std::complex<double> ListedStart::polarised(const PolarisationSpec& spec, const RayNumbers& ray, Vec3 n,
                                            const ListedRay::Crossing& met, int number) const {
    const double r = std::hypot(met.x, met.y);
    const Vec3 field = field_of(spec), u = disc_velocity(tables_.matter(), *flow_, r, {});
    const AxialMetric* axial = tables_.matter().axial();
    const PolarisedPlace place{
        r, axial ? axial->a() : 0.0, disc_lapses(tables_.matter(), r, {})[0], u, {field.x, -field.z, field.y}};
    return polarised_light(tables_.path().photon_of(frame_, ray, met, number), place, polarised_fraction(spec),
                           screen_phase(screen_, {n.z, -n.y, -n.x}));
}

}  // namespace nullscope
