// A neutron star: the Schwarzschild exterior down to a surface at r = radius (r_s), where light ends.
//
// 9/8 r_s is the least radius that pressure can hold up (Buchdahl 1959). Below 3/2 r_s the photon sphere lies outside of the
// surface; above, rays that graze the surface are what divides sky and star.
#pragma once
#include <map>
#include <memory>
#include <string>

#include "spacetime/schwarzschild.h"

namespace nullscope {

class NeutronStar final : public Spacetime {
public:
    static constexpr double kLeastRadius = 1.125, kLargestRadius = 1000.0;
    // Nearer than this, of the radius, a horizon of light lies within a few cells of the strip around the transverse direction.
    static constexpr double kStandoff = 1e-5;
    explicit NeutronStar(double radius) : radius_(radius) {}
    std::string_view name() const override { return "neutron-star"; }
    double lapse_squared(double r) const override { return exterior_.lapse_squared(r); }
    RadiusRange camera_range() const override { return {radius_ * (1.0 + kStandoff), kAnyRadius}; }
    std::optional<double> horizon_radius() const override { return std::nullopt; }
    std::optional<PhotonSphere> photon_sphere() const override { return exterior_.photon_sphere(); }
    bool bends_light() const override { return true; }
    InnerEnd inner_end() const override { return InnerEnd::kSurface; }
    std::optional<double> surface_radius() const override { return radius_; }
    double chi_from_radius(double r) const override { return exterior_.chi_from_radius(r); }
    double radius_from_chi(double chi) const override { return exterior_.radius_from_chi(chi); }
    double bending_density(double chi) const override { return exterior_.bending_density(chi); }
    double half_v_slope(double zeta) const override { return exterior_.half_v_slope(zeta); }
    double half_v_curvature(double zeta) const override { return exterior_.half_v_curvature(zeta); }

private:
    Schwarzschild exterior_;
    double radius_;
};

std::unique_ptr<Spacetime> make_neutron_star(const std::map<std::string, double>& parameters);

}  // namespace nullscope
