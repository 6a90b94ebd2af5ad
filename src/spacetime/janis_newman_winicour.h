// Janis, Newman and Winicour (1968): a mass with a scalar field, ds^2 = -f^g dt^2 + f^-g dr^2 + r^2 f^(1-g) dOmega^2, f = 1 - r_g/r,
// r_g = 1/g in r_s. g = 1 is Schwarzschild; below, r = r_g is a singular surface of no area where clocks stand still, and light ends. For
// g > 1/2 a photon sphere lies outside of it.
//
// With x = r_g/r, y = 1 - x: V = A/R^2 = (x y^(g - 1/2) / r_g)^2 = q_crit^2 sin^2(chi), x_c = 2/(1 + 2 g). From sqrt(V) by
// differentiation, and dphi/dr = 1/(R^2 sqrt(q^2 - V)):
//     h = sqrt(y) cos(chi)/(1 - x/x_c),    cos^2(chi) = 1 - V/V_c = -expm1(2 [ln(1 + a) - a] + (2 g - 1) [ln(1 - b) + b]),
// a = (x - x_c)/x_c, b = (x - x_c)/(1 - x_c): the terms that are linear in x - x_c cancel exactly.
#pragma once
#include "numeric/inverse_map.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {

class JanisNewmanWinicour final : public SphericalMetric, public ChiMap {
public:
    static constexpr double kLeast = 0.6;  // of g: at 1/2 the photon sphere meets the singular surface
    explicit JanisNewmanWinicour(double g);
    std::string_view name() const override { return "janis-newman-winicour"; }
    double lapse_squared(double r) const override;
    double areal_radius(double r) const override;
    double radial_stretch2(double r) const override { return 1.0 / lapse_squared(r); }
    // The singular surface: light ends there as at a horizon.
    std::optional<double> horizon_radius() const override { return r_g_; }
    std::optional<PhotonSphere> photon_sphere() const override { return PhotonSphere{r_g_ / x_c_, q_crit_}; }
    const ChiMap* chi() const override { return this; }
    double chi_from_radius(double r) const override;
    double radius_from_chi(double chi) const override;
    double bending_density(double chi) const override;

private:
    double rest(double r) const;
    double sine(double x, double y) const;
    double cosine_over_gap(double x, double y) const;  // cos(chi)/(1 - x/x_c), also where both vanish
    double chi_of(double x, double y) const;
    double density_at(double tau) const;  // x = 1 - exp(-tau)
    double tau_from_chi(double chi) const;
    double g_, r_g_, x_c_, q_crit_;
    InverseMap tau_of_;
};

}  // namespace nullscope
