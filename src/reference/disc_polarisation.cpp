#include "reference/disc_polarisation.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "observer/pose.h"
#include "spacetime/registry.h"

namespace nullscope::reference {
namespace {

// The equatorial plane at a place, in the coordinates of carried_axes.h: vectors by components in ingoing coordinates (v, r, theta, phi~).
class EquatorialPlace {
public:
    EquatorialPlace(const CarryingMetric& metric, const Vec3& x)
        : metric_(metric),
          x_(x),
          a_(metric.a()),
          r_(metric.radius(x)),
          flat_(x.x, x.y),
          out_(flat_ / std::complex(r_, a_)) {
        delta_ = r_ * r_ * (1 - metric.at(x).f) + a_ * a_;
    }
    double r() const { return r_; }
    FourVector ingoing(double v, double r, double theta, double phi) const {
        const std::complex<double> flat = r * out_ + std::complex(0.0, phi) * flat_;
        return {v - r, flat.real(), flat.imag(), -r_ * theta};
    }
    // By components of Boyer and Lindquist's t, r, phi, without rotation Schwarzschild's.
    FourVector outer(double t, double r, double phi) const {
        return ingoing(t + (r_ * r_ + a_ * a_) / delta_ * r, r, 0, phi + a_ / delta_ * r);
    }
    FourVector time() const { return outer((r_ * r_ + a_ * a_) / root(), 0, a_ / root()); }  // Carter's frame
    FourVector radial() const { return outer(0, std::sqrt(delta_) / r_, 0); }
    FourVector south() const { return ingoing(0, 0, 1 / r_, 0); }
    FourVector azimuthal() const { return outer(a_ / r_, 0, 1 / r_); }
    double product(const FourVector& u, const FourVector& v) const { return metric_.product(x_, u, v); }

private:
    double root() const { return r_ * std::sqrt(delta_); }
    const CarryingMetric& metric_;
    Vec3 x_;
    double a_, r_;
    std::complex<double> flat_, out_;
    double delta_ = 0;
};

FourVector sum(double a, const FourVector& u, double b, const FourVector& v) {
    FourVector w{};
    for (std::size_t m = 0; m < 4; ++m) w[m] = a * u[m] + b * v[m];
    return w;
}

// With the matter, after a boost without rotation from Carter's frame.
FourVector moved(const EquatorialPlace& at, const FourVector& b, const FourVector& u) {
    const FourVector e = at.time();
    return sum(1, b, at.product(u, b) / (1 - at.product(u, e)), sum(1, u, 1, e));
}

// epsilon_abcd p^a u^b k^c f^d: these coordinates have the determinant -1.
double volume(const FourVector& p, const FourVector& u, const FourVector& k, const FourVector& f) {
    const auto minor = [&](std::size_t i, std::size_t j, std::size_t l) {
        return u[i] * (k[j] * f[l] - k[l] * f[j]) - u[j] * (k[i] * f[l] - k[l] * f[i]) +
               u[l] * (k[i] * f[j] - k[j] * f[i]);
    };
    return p[0] * minor(1, 2, 3) - p[1] * minor(0, 2, 3) + p[2] * minor(0, 1, 3) - p[3] * minor(0, 1, 2);
}

}  // namespace

Result<DiscPolarisation> DiscPolarisation::make(const Scene& scene) {
    if (!scene.disc || scene.disc->polarisation.by == Polarisation::kOff)
        return bad_input("the scene has no polarised disc", "disc.polarisation = \"scattering\" or \"synchrotron\"");
    if (!scene.light.lensing)
        return bad_input("the reference carries no polarisation along straight light", "light.lensing = \"on\"");
    DiscPolarisation made;
    made.spec_ = scene.disc->polarisation, made.light_ = scene.light;
    TRY(spacetime, make_spacetime(scene.spacetime.metric, scene.spacetime.parameters));
    made.spacetime_ = std::move(*spacetime);
    TRY(metric, make_metric(scene.spacetime));
    made.metric_ = std::move(*metric);
    made.carrying_ = carrying_metric(*made.spacetime_);
    if (!made.carrying_) return bad_input("the metric has no discs");
    made.matter_ = std::make_shared<const DiscLight>(*made.metric_, *scene.disc, scene.light);
    return made;
}

Result<CameraAxes> DiscPolarisation::axes_of(const CameraSpec& camera) const {
    CameraAxes from{camera, {}};
    if (!light_.aberration) from.camera.velocity = {};
    TRY(pair, ingoing_hat_pair(*spacetime_, from.camera));
    from.tetrad = long_tetrad(*pair);
    return from;
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
    const EquatorialPlace place(*carrying_, axes->place);
    const DiscLight::Velocity v = flow == Flow::kCircle ? matter_->circling(place.r()) : matter_->velocity(place.r());
    const FourVector u = place.outer(v.t, v.r, v.phi);
    const Vec3 field = field_of(spec_);
    const FourVector b = sum(field.x, place.radial(), 1, sum(field.y, place.azimuthal(), -field.z, place.south()));
    const FourVector across = moved(place, b, u);
    const double right = volume(axes->right, u, axes->k, across), up = volume(axes->up, u, axes->k, across);
    const double cosine = std::abs(place.product(axes->k, place.south()) / place.product(axes->k, u));
    const double fraction = polarised_fraction(spec_).value_or(scattered_fraction(std::min(cosine, 1.0)));
    return Polarised{place.r(), std::remainder(std::atan2(up, right), M_PI), fraction};
}

}  // namespace nullscope::reference
