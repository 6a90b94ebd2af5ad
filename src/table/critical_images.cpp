#include "table/critical_images.h"

#include <algorithm>
#include <cmath>

namespace nullscope {
namespace {

constexpr double kDelta = 1e-7;                      // of the critical angle
constexpr double kBentFar = 0.04, kBentNear = 0.01;  // of the critical angle: where the next term is taken from
// Of chi from the photon sphere: from here on orbits wind as the limit does. A part of a rim's, for on its way in a ray is off the photon
// sphere by as much, and within kNearest the limit is not used.
constexpr double kNear = 0.3, kNearRim = 0.05, kNearest = 1e-4, kNever = 1e4;

// Discs: where there is a horizon.
double chi_of(const SphericalMetric& spacetime, double r) {
    const double least = spacetime.horizon_radius().value_or(spacetime.photon_sphere()->radius);
    return spacetime.chi()->chi_from_radius(std::max(r, least));
}

// Of a ray next to the critical one: what it sweeps between infinity and chi.
double from_infinity(const RayFamily& family, double chi) {
    constexpr double d2 = 1e-12;
    return family.table().through_from_infinity(std::sqrt(1.0 + d2), d2, chi);
}

}  // namespace

double swept_to(const RayFamily& family, Segment segment, double delta, double r) {
    if (!(delta < family.delta_limit(segment))) return NAN;
    const SphericalMetric& spacetime = family.spacetime();
    const double chi = chi_of(spacetime, r);
    const FanRay ray = family.ray(segment, delta);
    const double k = family.slope_at_sky(ray.q) / family.slope_at_sky(spacetime.photon_sphere()->q_crit),
                 omk2 = (1 - k) * (1 + k), sine = std::sin(chi) / k;
    if (omk2 > 0 ? segment == Segment::kCaptured || sine >= 1 : false) return NAN;
    const DeflectionTable& table = family.table();
    const auto through = [&](double to) { return table.through_from_infinity(k, -omk2, to); };
    return ray.phi_end - (omk2 > 0                   ? table.turning_to_sky(k, omk2, std::asin(sine))
                          : segment == Segment::kSky ? through(chi)
                                                     : through(family.chi_end()) - through(chi));
}

CriticalImages critical_images(const RayFamily& family, double inner, double outer) {
    const SphericalMetric& spacetime = family.spacetime();
    const auto swept = [&](Segment segment, double part) {
        return family.ray(segment, part * family.critical_angle()).phi_end;
    };
    CriticalImages images;
    const double rate = (swept(Segment::kSky, kDelta) - swept(Segment::kSky, 10 * kDelta)) / std::log(10.0);
    images.per_angle = 1.0 / rate;
    const auto place = [&](double r) {
        const double chi = chi_of(spacetime, r);
        const bool sky = chi < M_PI / 2;
        const double behind =
            sky ? from_infinity(family, chi) : from_infinity(family, family.chi_end()) - from_infinity(family, chi);
        const double angle = swept(sky ? Segment::kSky : Segment::kCaptured, kDelta) - behind;
        return (sky ? 1.0 : -1.0) * kDelta * family.critical_angle() * std::exp(angle / rate);
    };
    images.inner = place(inner);
    images.outer = place(outer);
    // What x lacks of delta, over delta |delta|, for the ray at that angle; 0 for one that does not come to this radius.
    const auto lack = [&](double c, double r, double part) {
        const Segment segment = c > 0 ? Segment::kSky : Segment::kCaptured;
        const double delta = part * family.critical_angle();
        const double phi = swept_to(family, segment, delta, r);
        if (std::isnan(phi)) return 0.0;
        const double x = std::fabs(c) * std::exp(-phi / rate);
        return (delta / x - 1) / x;
    };
    const auto bend = [&](double c, double r) {
        const double far = lack(c, r, kBentFar), near = lack(c, r, kBentNear);
        if (far == 0 || near == 0) return CriticalImages::Bend{};
        const double logarithm = (far - near) / std::log2(kBentFar / kBentNear);
        return CriticalImages::Bend{far - logarithm * std::log2(kBentFar * family.critical_angle()), logarithm};
    };
    images.inner_bend = bend(images.inner, inner);
    images.outer_bend = bend(images.outer, outer);
    const double inner_chi = chi_of(spacetime, inner), outer_chi = chi_of(spacetime, outer);
    const double near =
        std::min(kNear, kNearRim * std::min(std::fabs(inner_chi - M_PI / 2), std::fabs(outer_chi - M_PI / 2)));
    if (near < kNearest) {
        images.from_angle = kNever;
        return images;
    }
    const double past = family.beyond() ? std::min(inner_chi, M_PI / 2 - near) : std::max(outer_chi, M_PI / 2 + near);
    if (family.beyond() ? family.chi0() < past : family.chi0() > past)
        images.from_angle = std::fabs(from_infinity(family, past) - from_infinity(family, family.chi0())) +
                            family.swept_inside(spacetime.photon_sphere()->q_crit);
    return images;
}

// Newton's steps in ln |delta|, of which phi is linear but for O(delta).
double delta_of_image(const RayFamily& family, double r, double phi) {
    constexpr int kSteps = 40;
    constexpr double kSame = 2e-15;
    const SphericalMetric& spacetime = family.spacetime();
    const double rate = spacetime.chi()->bending_density(0.5 * M_PI);
    const Segment segment = r > spacetime.photon_sphere()->radius ? Segment::kSky : Segment::kCaptured;
    double log_delta = std::log(kDelta * family.critical_angle());
    for (int i = 0; i < kSteps; ++i) {
        const double step = (swept_to(family, segment, std::exp(log_delta), r) - phi) / rate;
        log_delta += step;
        if (!(std::fabs(step) > kSame * std::fabs(log_delta)))
            return (segment == Segment::kSky ? 1.0 : -1.0) * std::exp(log_delta);
    }
    return NAN;
}

double angle_about_disc(const RayFamily& family, double inner, double outer) {
    constexpr double kNone = 1e30, kRoom = 1.0;  // rad; rays beside the critical one are in reach for a little longer
    const SphericalMetric& spacetime = family.spacetime();
    if (spacetime.chi() == nullptr || !spacetime.horizon_radius()) return kNone;
    const double deepest = chi_of(spacetime, inner), highest = chi_of(spacetime, outer);
    if (deepest < 0.5 * M_PI - kDiscAside) return from_infinity(family, deepest) + kRoom;
    if (highest > 0.5 * M_PI + kDiscAside)
        return from_infinity(family, family.chi_end()) - from_infinity(family, highest) + kRoom;
    return kNone;
}

}  // namespace nullscope
