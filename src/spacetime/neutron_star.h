// A neutron star: the Schwarzschild exterior down to a surface at r = radius (r_s), where light ends.
//
// 9/8 r_s is the least radius that pressure can hold up (Buchdahl 1959). Below 3/2 r_s the photon sphere lies outside of the
// surface; above, rays that graze the surface are what divides sky and star.
#pragma once
#include "spacetime/schwarzschild.h"

namespace nullscope {

class NeutronStar final : public SphericalMetric {
public:
    static constexpr double kLeastRadius = 1.125, kLargestRadius = 1000.0;
    // Nearer than this, of the radius, a horizon of light lies within a few cells of the strip around the transverse direction.
    static constexpr double kStandoff = 1e-5;
    explicit NeutronStar(double radius) : radius_(radius) {}
    std::string_view name() const override { return "neutron-star"; }
    double lapse_squared(double r) const override { return exterior_.lapse_squared(r); }
    RadiusRange camera_range() const override { return {radius_ * (1.0 + kStandoff), kAnyRadius}; }
    std::optional<PhotonSphere> photon_sphere() const override { return exterior_.photon_sphere(); }
    InnerEnd inner_end() const override { return InnerEnd::kSurface; }
    std::optional<double> surface_radius() const override { return radius_; }
    const ChiMap* chi() const override { return &exterior_; }
    const OrbitEquation* orbit_equation() const override { return &exterior_; }

private:
    Schwarzschild exterior_;
    double radius_;
};

}  // namespace nullscope
