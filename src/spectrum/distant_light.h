// Light that reaches an observer at rest at infinity, traced back to where it first crosses the equatorial plane: all that a spectrum asks of
// a ray, some microseconds each.
//
// The observer's picture has Bardeen's coordinates (1973), r_s: alpha to the right and beta up, of a picture whose up is the axis of rotation.
// A photon of energy 1 at infinity then has, with i the inclination (between the line of sight and the axis),
//     lambda = -alpha sin i,   eta = beta^2 + (alpha^2 - a^2) cos^2 i   (angular momentum about the axis and Carter's constant),
// and in Mino's time tau, with zeta = 1/r and u = cos(theta),
//     u'^2 = eta - (eta + lambda^2 - a^2) u^2 - a^2 u^4,   u = cos i and u' = beta sin i at the observer,
//     zeta'' = -(eta + lambda^2 - a^2) zeta + 3/2 K zeta^2 + 2 ((a^2 - a lambda)^2 - K (a^2 + charge2)) zeta^3,
//     K = eta + (lambda - a)^2,   zeta = 0 and zeta' = 1 at the observer.
// u is an elliptic function: with u = sqrt(u_+) sin(psi), dpsi/dtau = sqrt(P + a^2 u_+ sin^2 psi) as in spacetime/photon_shell.h, the ray is in
// the plane at psi = pi, after an elliptic integral of the first kind (Carlson's R_F). Up to there zeta is followed in steps of sixth order;
// its equation is regular at turning points and on the horizon. Static metrics have a = 0 and zeta'' = -(eta + lambda^2) V'(zeta)/2.
#pragma once
#include <memory>
#include <optional>

#include "base/result.h"
#include "spacetime/spacetime.h"

namespace nullscope {

class DistantLight {
public:
    // degrees: an observer's inclination that is taken, of either face. Closer to the plane pictures of discs are too flat.
    static constexpr double kMost_deg = 89.0;
    // inclination: rad, [0, kMost_deg]. Errors: no disc in this metric, space that is not flat far out.
    static Result<DistantLight> make(std::shared_ptr<const Spacetime> spacetime, double inclination);

    const Spacetime& spacetime() const { return *spacetime_; }
    double cosine() const { return cosine_; }  // of the inclination
    double horizon() const { return horizon_; }

    struct Constants {
        double lambda, eta;
    };
    Constants constants(double alpha, double beta) const;
    // zeta: 1/r of the first crossing; slope: zeta' there, above 0 where the photon moves outward (it is traced backward).
    struct Crossing {
        double zeta, slope;
    };
    // Nothing: none outside of the horizon. Within 1e-10 of zeta.
    std::optional<Crossing> crossing(double alpha, double beta) const;

private:
    DistantLight() = default;
    double mino_time(const Constants& of, double beta) const;
    std::shared_ptr<const Spacetime> spacetime_;
    const OrbitEquation* orbit_ = nullptr;  // of a static metric
    double a_ = 0, charge2_ = 0, horizon_ = 0, cosine_ = 1, sine_ = 0;
};

}  // namespace nullscope
