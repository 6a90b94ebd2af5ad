// Free fall of a ball about a rotating hole, by the time t of the clocks at infinity.
#pragma once
#include <array>

#include "spacetime/axial_metric.h"

namespace nullscope {

// By the separated equations of Carter (1968) in Mino's time, rates divided by dt: with X = E (r^2 + a^2) - a L and K Carter's constant
//     w = dr/dlambda, w' = (X^2 - Delta (r^2 + K))'/2,  u = dtheta/dlambda, u' = (K - a^2 cos^2 - (a E sin - L/sin)^2)'/2,
//     dphi/dlambda = a X/Delta + L/sin^2 - a E,  dt/dlambda = (r^2 + a^2) X/Delta + a (L - a E sin^2).
// All rates by t are regular on the horizon, where dr/dt = 0 and dphi/dt is its angular velocity. Along the axis theta passes through 0.
class SpinFall {
public:
    struct Start {
        double r, theta;
        Vec3 velocity;  // along (e_r, e_theta, e_phi) of an observer at rest there
    };
    struct Place {
        double r, theta, phi, r_dot, theta_dot, phi_dot;  // phi since the start; by t
    };
    // Outside the ergosphere. metric: outlives this.
    SpinFall(const AxialMetric& metric, const Start& start);
    // Best asked for times ever farther from 0: some hundred steps an orbit, 1e-9 r_s in each. What reaches the horizon stays 1e-6 of it short.
    Place at(double t);
    double energy() const { return energy_; }      // per rest mass
    double momentum() const { return momentum_; }  // about the axis, r_s

private:
    using State = std::array<double, 5>;  // r, w, theta, u, phi
    State slope(const State& s) const;
    void step(double until);
    const AxialMetric& metric_;
    double outer_, energy_, momentum_, carter_;
    State start_, at_;
    double time_ = 0, length_;
};

}  // namespace nullscope
