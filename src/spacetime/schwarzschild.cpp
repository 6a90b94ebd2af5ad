#include "spacetime/schwarzschild.h"

#include <cmath>
#include <numbers>

namespace nullscope {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kPhotonSphereZeta = 2.0 / 3.0;
constexpr double kCriticalQ = 0.38490017945975050967;  // 2 / (3 sqrt 3)

}  // namespace

std::optional<PhotonSphere> Schwarzschild::photon_sphere() const { return PhotonSphere{1.5, kCriticalQ}; }

// Products only, so that no digit is lost near zeta = 0 (sin chi ~ zeta/q_crit), near 2/3 (cos chi ~ 2/3 - zeta) and
// near 1 (sin chi ~ sqrt(1 - zeta)/q_crit): 1 - V/q_crit^2 = (27/4) (zeta - 2/3)^2 (zeta + 1/3).
double Schwarzschild::chi_from_radius(double r) const {
    require_chi("Schwarzschild", r, 1.0);
    const double zeta = 1.0 / r;
    const double sine = zeta * std::sqrt(lapse_squared(r));
    const double cosine = (kPhotonSphereZeta - zeta) * std::sqrt(zeta + 1.0 / 3.0);
    return std::atan2(sine, cosine);  // both times q_crit
}

// zeta = 1/3 + (2/3) cos(2 (pi - chi)/3) as a product: no cancellation for chi -> 0.
double Schwarzschild::radius_from_chi(double chi) const {
    return 0.75 / (std::sin(chi / 3.0) * std::sin((2.0 * kPi - chi) / 3.0));
}

double Schwarzschild::bending_density(double chi) const {
    return 2.0 / std::numbers::sqrt3 * std::sin(2.0 / 3.0 * (kPi - chi));
}

}  // namespace nullscope
