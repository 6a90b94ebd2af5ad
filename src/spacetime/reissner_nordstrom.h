// Reissner-Nordstrom: A = 1 - zeta + kappa zeta^2, kappa = (Q/2M)^2: a hole of charge Q, 0 <= Q/M <= 1;
// above 1 there is none (naked_charge.h).
//
// With s = sqrt(1 - (Q/M)^2) and D = sqrt(1 + 8 s^2), everything is a product:
//     horizons     r = (1 +- s)/2:         A = (1 - r_o zeta)(1 - r_i zeta)
//     photon orbits r = (3 +- D)/4:        V' = 2 zeta (1 - r_c zeta)(1 - r_u zeta),  V = zeta^2 A
//     q_crit^2 = zeta_c^2 (2 - zeta_c)/4,  zeta_c = 1/r_c
//     q_crit^2 - V = (zeta_c - zeta)^2 g(zeta),  g = (2 - zeta_c)/4 + (r_c - 1/2) zeta - kappa zeta^2
// (g by division; for kappa = 0 it is zeta + 1/3). Hence sin(chi) = zeta sqrt(A)/q_crit, cos(chi) = (zeta_c - zeta) sqrt(g)/q_crit and
//     h = 2 q_crit sin(chi) cos(chi)/V' = sqrt(A g)/(q_crit r_c (1 - r_u zeta)),  1 - r_u zeta = (1 - r_o zeta) + (r_o - r_u) zeta.
// In the extremal hole r_o = r_i = r_u: h = sqrt(1 + 2 zeta - zeta^2) does not vanish at the horizon.
#pragma once
#include "numeric/inverse_map.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {

class ReissnerNordstrom final : public SphericalMetric, public ChiMap, public OrbitEquation {
public:
    explicit ReissnerNordstrom(double charge);  // Q/M, [0, 1]
    std::string_view name() const override { return "reissner-nordstrom"; }
    double lapse_squared(double r) const override;
    RadiusRange falling_range() const override { return {innermost_, kAnyRadius}; }
    std::optional<double> horizon_radius() const override { return outer_; }
    std::optional<PhotonSphere> photon_sphere() const override { return PhotonSphere{sphere_, q_crit_}; }
    const ChiMap* chi() const override { return this; }
    const OrbitEquation* orbit_equation() const override { return this; }
    std::optional<LapseRoots> lapse_roots() const override { return LapseRoots{outer_, inner_}; }
    double chi_from_radius(double r) const override;  // r >= horizon; aborts elsewhere
    double radius_from_chi(double chi) const override;
    double bending_density(double chi) const override;
    double half_v_slope(double zeta) const override { return zeta * (1.0 + zeta * (-1.5 + 2.0 * kappa_ * zeta)); }
    double half_v_curvature(double zeta) const override { return 1.0 + zeta * (-3.0 + 6.0 * kappa_ * zeta); }
    double lapse_slope(double zeta) const override { return 2.0 * kappa_ * zeta - 1.0; }
    double lapse_curvature(double) const override { return 2.0 * kappa_; }

private:
    double outside_of(double r) const;
    double outside(double zeta) const;
    double chi_of(double zeta, double outside) const;
    double density_at(double zeta) const;
    double zeta_from_chi(double chi) const;
    double kappa_, outer_, inner_, sphere_, zeta_c_, q_crit_, gap_;  // gap: r_o - r_u
    // Within the inner horizon, where V = q_crit^2 once more (g = 0): below it no ray to the sky is critical.
    double innermost_;
    InverseMap zeta_of_;
};

}  // namespace nullscope
