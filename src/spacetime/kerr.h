// Kerr: a hole that spins. Units r_s = 1, so M = 1/2; a = spin / 2 is the angular momentum per mass in r_s, the coordinates are those
// of Boyer and Lindquist. Horizons: r_+- = (1 +- sqrt(1 - spin^2))/2, the zeros of Delta = r^2 - r + a^2.
//
// No ray stays in a plane and there is no photon sphere: of the interface of spherical metrics only what has a meaning here is
// given; light is traced by shaders/core/kerr.glsl. Who can hold a camera: spin_frame.h.
#pragma once
#include <map>
#include <memory>

#include "spacetime/spacetime.h"

namespace nullscope {

class Kerr final : public Spacetime {
public:
    explicit Kerr(double spin_over_mass);  // (0, 1)
    std::string_view name() const override { return "kerr"; }
    double spin() const override { return a_; }
    double lapse_squared(double r) const override;  // of a camera without angular momentum in the equatorial plane
    double radial_stretch2(double r) const override { return r * r / delta(r); }  // in the equatorial plane
    std::optional<double> horizon_radius() const override { return outer_; }
    RadiusRange falling_range() const override { return {inner_horizon(), kAnyRadius}; }
    double inner_horizon() const { return a_ * a_ / outer_; }
    std::optional<PhotonSphere> photon_sphere() const override { return std::nullopt; }
    bool bends_light() const override { return true; }
    double chi_from_radius(double r) const override;  // this and what follows: aborts
    double radius_from_chi(double chi) const override;
    double bending_density(double chi) const override;
    double half_v_slope(double zeta) const override;
    double half_v_curvature(double zeta) const override;
    Matrix4 metric(double r, double theta) const override;
    Matrix4 inverse_metric(double r, double theta) const override;
    double delta(double r) const {
        return (r - outer_) * (r - inner_horizon());
    }  // a product: exact next to the horizon

private:
    double a_, outer_;
};

// spin = 0 makes the Schwarzschild metric, with its table.
std::unique_ptr<Spacetime> make_kerr(const std::map<std::string, double>& parameters);

}  // namespace nullscope
