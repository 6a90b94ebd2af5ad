#include "reference/photon_ring.h"

#include <cmath>
#include <vector>

#include "observer/observer.h"
#include "reference/root.h"
#include "spacetime/photon_shell.h"
#include "spacetime/registry.h"

namespace nullscope::reference {
namespace {

constexpr int kMostOrders = 16;
constexpr double kAside = 1e-4;        // rad along the ring, between which its tangent is taken
constexpr double kEdge = 1e-8;         // rad about the critical direction in which the edge between fates is sought
constexpr double kStep = 0.25;         // of ln(delta), between looks for an image
constexpr double kLeastDelta = 1e-15;  // rad
constexpr int kBits = 44;              // of ln(delta)
constexpr double kEndsBefore = 1e3;    // 1/r of a crossing that a ray does not come to

}  // namespace

Result<PhotonRing> PhotonRing::make(const Scene& scene) {
    PhotonRing ring;
    ring.scene_ = scene;
    ring.scene_.bodies.clear();
    CameraSpec& camera = ring.scene_.camera;
    TRY(spacetime, make_spacetime(scene.spacetime.metric, scene.spacetime.parameters));
    ring.spacetime_ = *spacetime;
    if (!(*spacetime)->rotates()) {
        if (!falls(camera)) camera.observer = ObserverKind::kStatic;
        camera.velocity = {};
    }
    TRY(orbit, photon_orbit(**spacetime, camera.theta, 0.0));
    if (!scene.light.lensing) return bad_input("light.lensing = false: light travels straight", "true");
    TRY(metric, make_metric(scene.spacetime));
    ring.metric_ = std::move(*metric);
    ring.none_ = std::make_shared<const Bodies>(ring.scene_, *ring.metric_);
    TRY(rays, ring.metric_->rays(ring.scene_, **spacetime, {ring.none_.get(), false, false, kMostOrders}));
    ring.rays_ = std::move(*rays);
    ring.critical_ = CriticalLight::make(**spacetime, camera, scene.light);
    if (!ring.critical_) return bad_input("the camera moves at the speed of light");
    return ring;
}

RayPtr PhotonRing::ray(const Place& place, double delta) const {
    const double angle = place.off + delta;
    return rays_->ray(place.critical * std::cos(angle) + place.across * std::sin(angle));
}

PhotonRing::Place PhotonRing::place(double psi) const {
    const Vec3 critical = critical_->direction(psi),
               along = critical_->direction(psi + kAside) - critical_->direction(psi - kAside);
    Place place{psi,
                critical,
                normalized(cross(along, critical)),
                0.0,
                photon_orbit(*spacetime_, scene_.camera.theta, psi)->r,
                0.5 * angle_between(critical, critical_->direction(psi + M_PI))};
    if (!spacetime_->rotates()) return place;
    double inside = -kEdge, outside = kEdge;
    for (double middle = 0.0; middle > inside && middle < outside; middle = 0.5 * (inside + outside)) {
        if (outside - inside < 1e-18) break;
        (ray(place, middle)->fate() == Fate::kEscaped ? outside : inside) = middle;
    }
    place.off = 0.5 * (inside + outside);
    return place;
}

std::optional<PhotonRing::Image> PhotonRing::image_at(const Place& place, int crossing, double delta) const {
    const RayPtr traced = ray(place, delta);
    const auto list = traced->crossings(crossing);
    if (static_cast<int>(list.size()) < crossing) return std::nullopt;
    const PlaneCrossing& there = list.back();
    const bool areal = spacetime_->rotates() || spacetime_->orbit_equation() != nullptr;
    return Image{delta, traced->swept(there.along), areal ? traced->delay(there.along) : kNotANumber, there.phi};
}

std::optional<PhotonRing::Image> PhotonRing::image_on(double side, const Place& place, int crossing, double r,
                                                      double below) const {
    const auto within = [&](double log_delta) {
        const auto list = ray(place, side * std::exp(log_delta))->crossings(crossing);
        if (static_cast<int>(list.size()) == crossing) return side * (1.0 / list.back().r - 1.0 / r);
        return side > 0.0 ? -1.0 / r : -kEndsBefore;
    };
    double high = std::log(side > 0.0 ? below : std::min(below, place.radius)), at_high = within(high);
    while (high > std::log(kLeastDelta)) {
        const double low = high - kStep, at_low = within(low);
        if (at_high < 0.0 && at_low >= 0.0)
            return image_at(place, crossing, side * std::exp(root_of(within, low, high, at_low, at_high, kBits)));
        high = low, at_high = at_low;
    }
    return std::nullopt;
}

std::optional<PhotonRing::Image> PhotonRing::image(const Place& place, int crossing, double r, double below) const {
    const double side = r > place.sphere ? 1.0 : -1.0;
    const auto found = image_on(side, place, crossing, r, below);
    return found ? found : image_on(-side, place, crossing, r, below);
}

std::optional<PhotonRing::HalfOrbit> PhotonRing::half_orbit(const Place& place, double r) const {
    const double side = r > place.sphere ? 1.0 : -1.0;
    std::vector<Image> images;
    double below = place.radius;
    for (int crossing = 2; below > kEnd * place.radius; ++crossing) {
        const auto image = crossing <= kMostOrders ? image_on(side, place, crossing, r, below) : std::nullopt;
        if (!image && (!images.empty() || crossing > kMostOrders)) return std::nullopt;
        if (image) images.push_back(*image), below = std::fabs(image->delta);
    }
    if (images.size() < 4) return std::nullopt;
    images.erase(images.begin(), images.end() - 4);
    const double ratio = images[3].delta / images[2].delta;
    const auto limit = [&](const auto& between) {
        return limit_of(between(images[0], images[1]), between(images[1], images[2]), between(images[2], images[3]),
                        ratio);
    };
    // Over the poles the azimuth jumps by pi, either way.
    const double turn = images[2].azimuth - images[3].azimuth;
    const auto apart = [turn](const Image& a, const Image& b) {
        return std::remainder(a.azimuth - b.azimuth - turn, 2.0 * M_PI);
    };
    return HalfOrbit{limit([](const Image& a, const Image& b) { return std::log(a.delta / b.delta); }),
                     limit([](const Image& a, const Image& b) { return b.delay - a.delay; }), turn + limit(apart)};
}

}  // namespace nullscope::reference
