#include "reference/disc_polarisation.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "observer/pose.h"
#include "reference/carrying_place.h"
#include "scene/leaning_disc.h"
#include "spacetime/registry.h"

namespace nullscope::reference {
namespace {

// Carter's frame in the equatorial plane.
struct CarterFrame {
    FourVector time, radial, south, azimuthal;
};
CarterFrame carter_frame(const CarryingPlace& at, double a) {
    const double r = at.r(), root = r * std::sqrt(at.delta());
    return {at.outer((r * r + a * a) / root, 0, 0, a / root), at.outer(0, std::sqrt(at.delta()) / r, 0, 0),
            at.ingoing(0, 0, 1 / r, 0), at.outer(a / r, 0, 0, 1 / r)};
}

}  // namespace

Result<DiscPolarisation> DiscPolarisation::make(const Scene& scene) {
    if (!scene.disc || scene.disc->polarisation.by == Polarisation::kOff)
        return bad_input("the scene has no polarised disc", "disc.polarisation = \"scattering\" or \"synchrotron\"");
    if (!scene.light.lensing)
        return bad_input("the reference carries no polarisation along straight light", "light.lensing = \"on\"");
    DiscPolarisation made;
    made.spec_ = scene.disc->polarisation, made.light_ = scene.light, made.plane_ = disc_plane_of(scene);
    TRY(spacetime, make_spacetime(scene.spacetime.metric, scene.spacetime.parameters));
    made.spacetime_ = std::move(*spacetime);
    if (disc_leans(scene) && made.spacetime_->rotates())
        return bad_input("the reference polarises no disc that leans about a rotating hole", "disc.tilt = 0");
    TRY(metric, make_metric(scene.spacetime));
    made.metric_ = std::move(*metric);
    made.carrying_ = carrying_metric(*made.spacetime_);
    if (!made.carrying_) return bad_input("the metric has no discs");
    made.matter_ = std::make_shared<const DiscLight>(*made.metric_, *scene.disc, scene.light);
    return made;
}

Result<CameraAxes> camera_axes(const Spacetime& spacetime, const CameraSpec& camera) {
    TRY(pair, ingoing_hat_pair(spacetime, camera));
    return CameraAxes{camera, long_tetrad(*pair)};
}

Result<CameraAxes> DiscPolarisation::axes_of(const CameraSpec& camera) const {
    CameraSpec still = camera;
    if (!light_.aberration) still.velocity = {};
    TRY(axes, camera_axes(*spacetime_, still));
    return turned(std::move(*axes));
}

CameraAxes DiscPolarisation::turned(CameraAxes axes) const {
    if (plane_.normal == Vec3{0, 0, 1}) return axes;
    const Mat3 disc_from_world = transposed({plane_.x, plane_.y, plane_.normal});
    const Mat3 here = disc_from_world * world_from_static(axes.camera.theta, axes.camera.phi);
    axes.camera.theta = std::atan2(std::hypot(here.a.x, here.a.y), here.a.z);
    axes.camera.phi = std::atan2(here.a.y, here.a.x);
    const Mat3 there = transposed(world_from_static(axes.camera.theta, axes.camera.phi));
    const Vec3 south = there * here.b;
    for (auto& row : axes.tetrad)
        std::tie(row[2], row[3]) = std::pair(row[2] * south.y - row[3] * south.z, row[2] * south.z + row[3] * south.y);
    return axes;
}

std::optional<Polarised> DiscPolarisation::at(const RayQuery& query, int crossing) const {
    CameraSpec camera;
    camera.r = query.r, camera.theta = query.theta, camera.phi = query.phi;
    camera.observer = query.frame == LocalFrame::kRain ? ObserverKind::kRain
                      : spacetime_->rotates()          ? ObserverKind::kZamo
                                                       : ObserverKind::kStatic;
    const auto from = axes_of(camera);
    if (!from) return {};
    return at(*from, normalized(Vec3{query.n.z, -query.n.y, query.n.x}), crossing);
}

std::optional<Polarised> DiscPolarisation::at(const CameraAxes& from, Vec3 direction, int crossing, Flow flow) const {
    const auto axes = carried_axes(*carrying_, from.camera, from.tetrad, direction, crossing);
    if (!axes) return {};
    const CarryingPlace place(*carrying_, axes->place);
    const CarterFrame frame = carter_frame(place, carrying_->a());
    const DiscLight::Velocity v = flow == Flow::kCircle ? matter_->circling(place.r()) : matter_->velocity(place.r());
    const FourVector u = place.outer(v.t, v.r, 0, v.phi);
    const Vec3 field = field_of(spec_);
    const FourVector b = sum_of(field.x, frame.radial, 1, sum_of(field.y, frame.azimuthal, -field.z, frame.south));
    const FourVector across = moved(place, b, u, frame.time);
    const double right = volume_of(axes->right, u, axes->k, across), up = volume_of(axes->up, u, axes->k, across);
    const double cosine = std::abs(place.product(axes->k, frame.south) / place.product(axes->k, u));
    const double fraction = polarised_fraction(spec_).value_or(scattered_fraction(std::min(cosine, 1.0)));
    return Polarised{place.r(), std::remainder(std::atan2(up, right), M_PI), fraction};
}

}  // namespace nullscope::reference
