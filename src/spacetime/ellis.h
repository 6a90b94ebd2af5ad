// Ellis wormhole: ds^2 = -dt^2 + dl^2 + (l^2 + a^2) dOmega^2 with throat radius a, l from -infinity to infinity (Ellis 1973).
//
// V = 1/(l^2 + a^2) = sin^2(chi)/a^2 with l = a cot(chi): q_crit = 1/a at the throat, chi = pi is the other sky. Then
//     dphi = dl/((l^2 + a^2) sqrt(q^2 - V)) = dchi / sqrt(k^2 - sin^2 chi):   h = 1.
#pragma once
#include <cmath>

#include "spacetime/spherical_metric.h"

namespace nullscope {

class Ellis final : public SphericalMetric, public ChiMap {
public:
    explicit Ellis(double throat) : throat_(throat) {}
    std::string_view name() const override { return "ellis"; }
    double lapse_squared(double) const override { return 1.0; }
    double areal_radius(double l) const override { return std::hypot(l, throat_); }
    double radial_stretch2(double) const override { return 1.0; }
    RadiusRange camera_range() const override { return {-kAnyRadius, kAnyRadius}; }
    std::optional<PhotonSphere> photon_sphere() const override { return PhotonSphere{0.0, 1.0 / throat_}; }
    const ChiMap* chi() const override { return this; }
    InnerEnd inner_end() const override { return InnerEnd::kOtherSky; }
    double chi_from_radius(double l) const override { return std::atan2(throat_, l); }
    double radius_from_chi(double chi) const override { return throat_ * std::cos(chi) / std::sin(chi); }
    double bending_density(double) const override { return 1.0; }
    double length_unit() const override { return throat_; }
    double radius_slope(double l) const override { return l / areal_radius(l); }
    double radius_curvature(double l) const override {
        const double radius = areal_radius(l), part = throat_ / radius;
        return part * part / radius;
    }

private:
    double throat_;
};

}  // namespace nullscope
