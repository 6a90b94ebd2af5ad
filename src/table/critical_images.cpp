#include "table/critical_images.h"

#include <algorithm>
#include <cmath>

namespace nullscope {
namespace {

constexpr double kDelta = 1e-7;  // of the critical angle
constexpr double kNear = 0.3;    // chi from the photon sphere: from here on orbits wind as the limit does

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
    const double past =
        family.beyond() ? std::min(chi_of(inner), M_PI / 2 - kNear) : std::max(chi_of(outer), M_PI / 2 + kNear);
    if (family.beyond() ? family.chi0() < past : family.chi0() > past)
        images.from_angle = std::fabs(from_infinity(past) - from_infinity(family.chi0())) +
                            family.swept_inside(spacetime.photon_sphere()->q_crit);
    return images;
}

}  // namespace nullscope
