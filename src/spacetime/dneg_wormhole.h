// The wormhole of James, von Tunzelmann, Franklin and Thorne (Am. J. Phys. 83, 486 (2015), eq. 5): ds^2 = -dt^2 + dl^2 + R^2 dOmega^2,
//     R = rho for |l| < a,   R = rho + M f(x) beyond,   f = x atan x - ln(1 + x^2)/2,   x = 2 (|l| - a)/(pi M),   dR/dl = (2/pi) atan x:
// a tube of radius rho and length 2 a between two regions that bend light. The lensing width W = 1.42953 M is R - rho where the embedded
// surface is as steep as 45 degrees, dR/dl = 1/sqrt 2.
//
// V = 1/R^2 = q_crit^2 sin^2(chi): sin(chi) = rho/R, q_crit = 1/rho, and from sin(chi) = rho/R by differentiation
//     h = (rho/R^2) |dl/dchi| = cos(chi)/(dR/dl),  at the throat (pi/2) sqrt(M/rho).
// The tube has chi = pi/2 throughout; what rays sweep in it comes apart (tube_beyond). The inverse of f is taken by Newton's steps: f
// is convex, so they come down to the root from the right.
#pragma once
#include "spacetime/spherical_metric.h"

namespace nullscope {

class DnegWormhole final : public SphericalMetric, public ChiMap {
public:
    static constexpr double kWidthOverMass = 1.42953;          // W/M as the paper prints it
    static constexpr double kLongest = 10.0;                   // 2 a, throat radii
    static constexpr double kNarrowest = 0.02, kWidest = 2.0;  // W, throat radii: what the deflection table resolves
    DnegWormhole(double throat, double length, double width);  // length, width in throat radii
    std::string_view name() const override { return "dneg-wormhole"; }
    double lapse_squared(double) const override { return 1.0; }
    double areal_radius(double l) const override;
    double radial_stretch2(double) const override { return 1.0; }
    RadiusRange camera_range() const override { return {-kAnyRadius, kAnyRadius}; }
    std::optional<PhotonSphere> photon_sphere() const override { return PhotonSphere{0.0, 1.0 / throat_}; }
    const ChiMap* chi() const override { return this; }
    InnerEnd inner_end() const override { return InnerEnd::kOtherSky; }
    double chi_from_radius(double l) const override;
    double radius_from_chi(double chi) const override;  // in the tube, chi = pi/2: its mouth at l = a
    double bending_density(double chi) const override;
    bool logarithm_at_sky() const override { return true; }
    double tube_beyond(double l) const override;
    double length_unit() const override { return throat_; }
    double radius_slope(double l) const override;
    double radius_curvature(double l) const override;  // jumps at the tube's rims
    double logarithm_length() const override { return mass_; }

private:
    double x_of_chi(double chi) const;  // >= 0
    double throat_, half_length_, mass_;
};

}  // namespace nullscope
