#include "observer/critical_light.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "observer/pose.h"
#include "observer/spin_frame.h"
#include "spacetime/axial_metric.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {
namespace {

constexpr double kBeyondOrbits = 2.0 + 1e-6;  // r_s: the outermost orbit of light, against the fastest spin, is at 4 M
constexpr int kHalvings = 52;

struct Photon {
    double f, t;     // F, T
    double outward;  // what is positive where light comes outward, the root of F^2 - outward inward T
};

// r_p. The left side less the right one falls through 0 between the horizon and kBeyondOrbits.
double photon_orbit(const AxialMetric& metric, const SpinPlace& p, double cosine_psi) {
    const double polar = p.a * p.cosine, around = p.a * p.sine * cosine_psi;
    double inside = metric.outer_horizon(), outside = kBeyondOrbits;
    for (int i = 0; i < kHalvings; ++i) {
        const double r = 0.5 * (inside + outside), delta = metric.delta(r);
        const bool falls_short =
            (r * r + polar * polar) * (2.0 * r - 1.0) > 4.0 * r * (delta + around * std::sqrt(delta));
        (falls_short ? inside : outside) = r;
    }
    return 0.5 * (inside + outside);
}

// X^2 - Delta K = (r - r_p)^2 (r^2 + 2 r_p r + 3 r_p^2 + 2 (a^2 - a lambda) - K), X = r^2 + a^2 - a lambda.
Photon photon_from(const SpinPlace& p, const AxialMetric& metric, double r_p) {
    const double delta = metric.delta(r_p), slope = 2.0 * r_p - 1.0, x_p = 4.0 * r_p * delta / slope,
                 carter = x_p * x_p / delta, twist = x_p - r_p * r_p;
    const double rest = p.r * p.r + 2.0 * r_p * p.r + 3.0 * r_p * r_p + 2.0 * twist - carter;
    return {(p.r * p.r + twist) / p.sigma, carter / p.sigma, (p.r - r_p) * std::sqrt(std::max(rest, 0.0)) / p.sigma};
}

Photon photon_from(const PhotonSphere& sphere, double r, double reach, double lapse2) {
    const double t = 1.0 / (sphere.q_crit * sphere.q_crit * reach * reach),
                 root = std::sqrt(std::max(1.0 - lapse2 * t, 0.0));
    return {1.0, t, r >= sphere.radius ? root : -root};
}

}  // namespace

std::optional<PhotonSphere> open_photon_sphere(const Spacetime& spacetime) {
    if (const SphericalMetric* spherical = spacetime.spherical())
        if (const auto barrier = spherical->barrier(); barrier && barrier->c[0] == 0.0)
            return PhotonSphere{1.0 / barrier->zeta, std::sqrt(barrier->v)};
    const auto sphere = spacetime.photon_sphere();
    return sphere && sphere->radius > spacetime.surface_radius().value_or(-kAnyRadius) ? sphere : std::nullopt;
}

std::optional<CriticalLight> CriticalLight::make(const Spacetime& spacetime, const CameraSpec& camera,
                                                 const LightSpec& light) {
    CriticalLight made;
    made.spinning_ = spacetime.axial();
    const auto sphere = open_photon_sphere(spacetime);
    if (!light.lensing || (!sphere && made.spinning_ == nullptr)) return std::nullopt;
    made.camera_ = camera;
    if (!light.aberration) made.camera_.observer = ObserverKind::kStatic, made.camera_.velocity = {};
    const auto observer = observer_of(spacetime, made.camera_);
    if (!observer || !(length(observer->velocity) < 1.0)) return std::nullopt;
    made.observer_ = *observer;
    made.sphere_ = sphere.value_or(PhotonSphere{});
    made.reach_ = spacetime.areal_radius(camera.r);
    made.to_camera_ = boost(-observer->velocity);
    made.axes_ = observer->turn * static_from_camera(camera);
    return made;
}

Vec3 CriticalLight::direction(double angle) const {
    const double outward = observer_.frame.outward, inward = observer_.frame.inward;
    Photon photon{};
    if (spinning_ != nullptr) {
        const SpinPlace place = spin_place(*spinning_, camera_.r, camera_.theta);
        photon = photon_from(place, *spinning_, photon_orbit(*spinning_, place, std::cos(angle)));
    } else {
        photon = photon_from(sphere_, camera_.r, reach_, outward * inward);
    }
    // Of the two roots of u each is where it does not cancel.
    const double u = photon.outward > 0.0 ? inward * photon.t / (photon.f + photon.outward)
                                          : (photon.f - photon.outward) / outward,
                 v = photon.t / u, across = std::sqrt(photon.t);
    const double k0 = 0.5 * (u + v), k3 = across * std::cos(angle), speed = observer_.azimuthal_velocity,
                 gamma = 1.0 / std::sqrt((1.0 - speed) * (1.0 + speed));
    const std::array<double, 4> k{gamma * (k0 - speed * k3), 0.5 * (v - u), across * std::sin(angle),
                                  gamma * (k3 - speed * k0)};
    double seen[4]{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) seen[i] += to_camera_[i][j] * k[j];
    return normalized(transposed(axes_) * Vec3{-seen[1], -seen[2], -seen[3]});
}

}  // namespace nullscope
