// What a rotating metric of Kerr's form has beyond Spacetime, in Boyer and Lindquist's coordinates:
//     Delta = r^2 - 2 m(r) r + a^2,   Sigma = r^2 + a^2 cos^2(theta),   2 m(r) = 1 - charge2/r  (units r_s = 1, M = 1/2),
//     ds^2 = -(1 - 2 m r/Sigma) dt^2 - (4 m a r sin^2/Sigma) dt dphi + Sigma/Delta dr^2 + Sigma dtheta^2
//            + (r^2 + a^2 + 2 m a^2 r sin^2/Sigma) sin^2 dphi^2.
// charge2 = (Q/2M)^2 is 0 for Kerr (1963) and above 0 for Kerr and Newman (1965), whose charge light feels by the
// metric alone. a: angular momentum per mass, r_s; of either sign, and nothing is mirrored. Horizons:
// r_+- = (1 +- sqrt(1 - (a/M)^2 - (Q/M)^2))/2, the zeros of Delta.
//
// No ray stays in a plane and there is no photon sphere; light is traced by shaders/mino/kerr.glsl. Who can hold a
// camera: spin_frame.h.
#pragma once
#include "spacetime/spacetime.h"

namespace nullscope {

class AxialMetric final : public Spacetime {
public:
    static constexpr double kRounding = 1e-15;  // of (a/M)^2 + (Q/M)^2: as much above 1 is 1
    // r_+ - r_- of extremal holes, r_s: a double root of Delta is drawn as two, which puts a^2 off by 2.5e-17.
    static constexpr double kLeastApart = 1e-8;
    // Of M: a/M in [-1, 1] and not 0, Q/M >= 0 with (a/M)^2 + (Q/M)^2 <= 1. Below 0 the hole turns towards falling phi.
    AxialMetric(std::string_view name, double spin_over_mass, double charge_over_mass);
    std::string_view name() const override { return name_; }
    const AxialMetric* axial() const override { return this; }
    double a() const override { return a_; }
    double azimuth_ahead(double r) const override;  // outside the outer horizon
    double charge2() const { return charge2_; }
    double outer_horizon() const { return outer_; }
    double inner_horizon() const { return inner_; }
    double delta(double r) const { return (r - outer_) * (r - inner_); }  // a product: exact next to a horizon
    double two_mass(double r) const { return 1.0 - charge2_ / r; }        // 2 m(r)

    double lapse_squared(double r) const override;
    std::optional<double> horizon_radius() const override { return outer_; }
    RadiusRange falling_range() const override { return {inner_, kAnyRadius}; }
    bool knows_light_time() const override { return true; }
    bool can_have_disc() const override { return true; }
    bool can_have_bodies() const override { return true; }
    Matrix4 metric(double r, double theta) const override;
    Matrix4 inverse_metric(double r, double theta) const override;
    std::optional<Equator> equator(double r) const override;

private:
    std::string_view name_;
    double a_, charge2_, outer_, inner_;
};

}  // namespace nullscope
