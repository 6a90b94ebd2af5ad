// Reissner-Nordstrom without horizon, Q/M > 1: A = 1 - zeta + kappa zeta^2 > 0, kappa = (Q/2M)^2 > 1/4.
//
// V = zeta^2 A grows without bound inward, so every ray turns and comes back to the sky; there is no angle chi. Up to kappa = 9/32 V
// has a maximum at zeta_d = (3 - sqrt(9 - 32 kappa))/(8 kappa), the photon sphere, where rays divide, and behind it a minimum, about
// which rays are trapped: cameras stand outside. Beyond, zeta_d = 3/(8 kappa), where V' is least, is where neighbouring rays come apart
// fastest. About zeta_d V is the polynomial of barrier().
#pragma once
#include "spacetime/spherical_metric.h"

namespace nullscope {

class NakedCharge final : public SphericalMetric, public OrbitEquation {
public:
    static constexpr double kMost = 3.0;  // Q/M
    explicit NakedCharge(double charge);  // Q/M > 1
    std::string_view name() const override { return "reissner-nordstrom"; }
    double lapse_squared(double r) const override { return 1.0 + (kappa_ / r - 1.0) / r; }
    RadiusRange camera_range() const override { return {traps_ ? 1.0 / zeta_d_ : 0.0, kAnyRadius}; }
    InnerEnd inner_end() const override { return InnerEnd::kSameSky; }
    std::optional<Barrier> barrier() const override;
    const OrbitEquation* orbit_equation() const override { return this; }
    double half_v_slope(double zeta) const override { return zeta * (1.0 + zeta * (-1.5 + 2.0 * kappa_ * zeta)); }
    double half_v_curvature(double zeta) const override { return 1.0 + zeta * (-3.0 + 6.0 * kappa_ * zeta); }
    double lapse_slope(double zeta) const override { return 2.0 * kappa_ * zeta - 1.0; }
    double lapse_curvature(double) const override { return 2.0 * kappa_; }

private:
    double kappa_, zeta_d_;
    bool traps_;
};

}  // namespace nullscope
