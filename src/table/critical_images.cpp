#include "table/critical_images.h"

#include <algorithm>
#include <cmath>

namespace nullscope {
namespace {

constexpr double kDelta = 1e-7;                      // of the critical angle
constexpr double kBentFar = 0.04, kBentNear = 0.01;  // of the critical angle: where the next term is taken from
constexpr double kNear = 0.3;  // chi from the photon sphere: from here on orbits wind as the limit does

}  // namespace

CriticalImages critical_images(const RayFamily& family, double inner, double outer) {
    const SphericalMetric& spacetime = family.spacetime();
    // Discs: where there is a horizon.
    const double least = spacetime.horizon_radius().value_or(spacetime.photon_sphere()->radius);
    const auto chi_of = [&](double r) { return spacetime.chi()->chi_from_radius(std::max(r, least)); };
    // Of a ray next to the critical one: what it sweeps between infinity and chi.
    constexpr double d2 = 1e-12;
    const auto from_infinity = [&](double chi) {
        return family.table().through_from_infinity(std::sqrt(1.0 + d2), d2, chi);
    };
    const auto swept = [&](Segment segment, double part) {
        return family.ray(segment, part * family.critical_angle()).phi_end;
    };
    CriticalImages images;
    const double rate = (swept(Segment::kSky, kDelta) - swept(Segment::kSky, 10 * kDelta)) / std::log(10.0);
    images.per_angle = 1.0 / rate;
    const auto place = [&](double r) {
        const double chi = chi_of(r);
        const bool sky = chi < M_PI / 2;
        const double behind = sky ? from_infinity(chi) : from_infinity(family.chi_end()) - from_infinity(chi);
        const double angle = swept(sky ? Segment::kSky : Segment::kCaptured, kDelta) - behind;
        return (sky ? 1.0 : -1.0) * kDelta * family.critical_angle() * std::exp(angle / rate);
    };
    images.inner = place(inner);
    images.outer = place(outer);
    // What x lacks of delta, over delta |delta|, for the ray at that angle; 0 for one that does not come to this radius.
    const auto lack = [&](double c, double r, double part) {
        const Segment segment = c > 0 ? Segment::kSky : Segment::kCaptured;
        const double delta = part * family.critical_angle();
        if (!(delta < family.delta_limit(segment))) return 0.0;
        const FanRay ray = family.ray(segment, delta);
        const double k = family.slope_at_sky(ray.q) / family.slope_at_sky(spacetime.photon_sphere()->q_crit),
                     omk2 = (1 - k) * (1 + k), sine = std::sin(chi_of(r)) / k;
        if (omk2 > 0 ? segment == Segment::kCaptured || sine >= 1 : false) return 0.0;
        const double behind = omk2 > 0 ? family.table().turning_to_sky(k, omk2, std::asin(sine))
                              : segment == Segment::kSky
                                  ? family.table().through_from_infinity(k, -omk2, chi_of(r))
                                  : family.table().through_from_infinity(k, -omk2, family.chi_end()) -
                                        family.table().through_from_infinity(k, -omk2, chi_of(r));
        const double x = std::fabs(c) * std::exp(-(ray.phi_end - behind) / rate);
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
    const double past =
        family.beyond() ? std::min(chi_of(inner), M_PI / 2 - kNear) : std::max(chi_of(outer), M_PI / 2 + kNear);
    if (family.beyond() ? family.chi0() < past : family.chi0() > past)
        images.from_angle = std::fabs(from_infinity(past) - from_infinity(family.chi0())) +
                            family.swept_inside(spacetime.photon_sphere()->q_crit);
    return images;
}

}  // namespace nullscope
