// Schwarzschild: A = 1 - zeta, the spherical black hole without charge. Horizon at zeta = 1, photon sphere at zeta =
// 2/3.
//
// V = zeta^2 (1 - zeta) = q_crit^2 sin^2(chi) with q_crit = 2/(3 sqrt 3) is solved by the triple-angle formula
//     zeta = 1/3 + (2/3) cos(2 (pi - chi)/3),
// since with c = cos(theta): (1/3 + 2c/3)^2 (2/3 - 2c/3) = (2/27)(1 + 3c - 4c^3) = (4/27) sin^2(3 theta/2). Then
//     h = 2 q_crit sin(chi) cos(chi) / V'(zeta) = sqrt((1 - zeta)(1 + 3 zeta)) = (2/sqrt 3) sin(2 (pi - chi)/3),
// with h = 1 at infinity and on the photon sphere, 0 at the horizon.
#pragma once
#include "spacetime/spherical_metric.h"

namespace nullscope {

class Schwarzschild final : public SphericalMetric, public ChiMap, public OrbitEquation {
public:
    std::string_view name() const override { return "schwarzschild"; }
    // No digit is lost at the horizon.
    double lapse_squared(double r) const override { return r < 2.0 ? (r - 1.0) / r : 1.0 - 1.0 / r; }
    RadiusRange falling_range() const override { return {0.0, kAnyRadius}; }
    std::optional<double> horizon_radius() const override { return 1.0; }
    std::optional<PhotonSphere> photon_sphere() const override;
    const ChiMap* chi() const override { return this; }
    const OrbitEquation* orbit_equation() const override { return this; }
    std::optional<LapseRoots> lapse_roots() const override { return LapseRoots{1.0, 0.0}; }
    double chi_from_radius(double r) const override;  // r >= 1; aborts elsewhere
    double radius_from_chi(double chi) const override;
    double bending_density(double chi) const override;
    double half_v_slope(double zeta) const override { return 0.5 * zeta * (2.0 - 3.0 * zeta); }
    double half_v_curvature(double zeta) const override { return 1.0 - 3.0 * zeta; }
    double lapse_slope(double) const override { return -1.0; }
    double lapse_curvature(double) const override { return 0.0; }
};

}  // namespace nullscope
