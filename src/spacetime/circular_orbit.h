// Matter in the equatorial plane: circular geodesics, and inside the innermost stable one the fall that keeps its
// constants. From the equatorial metric alone, the same for every spacetime; towards growing phi, which is the direction in which a
// hole of a > 0 turns.
//
// Omega = (sqrt(g_tphi'^2 - g_tt' g_phiphi') - g_tphi')/g_phiphi', u^t = 1/sqrt(-g_tt - (2 g_tphi + g_phiphi Omega) Omega),
// E = -u_t, L = u_phi (Bardeen, Press and Teukolsky 1972). With D = g_tphi^2 - g_tt g_phiphi and
// N = E^2 g_phiphi + 2 E L g_tphi + L^2 g_tt, D g_rr (u^r)^2 = N - D: the orbit is stable where N'' < D''.
#pragma once
#include <array>
#include <optional>

#include "spacetime/spacetime.h"

namespace nullscope {

// Towards growing phi, or towards falling phi, whichever way a hole turns: where a is below 0 eastward orbits are the retrograde ones.
// The same without rotation.
enum class Sense { kEastward, kWestward };
inline double sign_of(Sense sense) { return sense == Sense::kEastward ? 1.0 : -1.0; }

struct CircularOrbit {
    double u_t;       // dt/dtau
    double omega;     // dphi/dt, c/r_s
    double energy;    // per rest mass
    double momentum;  // L per rest mass, r_s c
};

// Nothing where there is no such geodesic: at and inside light's own circular orbit, where a cosmological constant pulls
// outward, and where the spacetime has no Equator. Flat space: matter at rest.
// Westward, omega and momentum are below 0.
std::optional<CircularOrbit> circular_orbit(const Spacetime& spacetime, double r, Sense sense = Sense::kEastward);

// Of A = (1 - x zeta)(1 - y zeta), by which matter goes round with w^2 = A'/(2 r) = zeta^3 ((x + y)/2 - x y zeta) and
// Omega = w/(1 + a w); about a rotating hole A = 1 - zeta + charge2 zeta^2 takes its place. In flat space matter rests. Other metrics
// have no such numbers: (0, 0).
std::array<double, 2> circular_rate_numbers(const Spacetime& spacetime);
bool has_circular_rate_numbers(const Spacetime& spacetime);
// Omega^2 r^3 of a metric without rotation, 0 where it has no equator; negative where no matter can go round, being pulled outward.
double circular_rate_scaled(const Spacetime& spacetime, double r);

// Radius in r_s, a rounding inward, of light's own circular orbit, the innermost of all circular orbits of that sense:
// light that is on its way in there does not turn any more. The spacetime must have an Equator and a horizon.
double light_orbit(const Spacetime& spacetime, Sense sense = Sense::kEastward);
double innermost_light_orbit(const Spacetime& spacetime);  // of either sense

// Radius in r_s of the innermost stable circular orbit; nothing where light runs straight, or no orbit is stable.
std::optional<double> innermost_stable_orbit(const Spacetime& spacetime, Sense sense = Sense::kEastward);

// Radius in r_s, a rounding inward, beyond which a cosmological constant pulls matter outward; kAnyRadius where none does.
double outermost_circular_orbit(const Spacetime& spacetime);

// Contravariant four-velocity (u^t, u^r, u^phi) of the disc's matter at r outside the horizon: circular down to the
// innermost stable orbit, falling with that orbit's energy and angular momentum inside. Continuous, with a continuous
// first derivative but for u^r, which begins as (r_isco - r)^(3/2). The spacetime must have an Equator.
struct MatterVelocity {
    double u_t, u_r, u_phi;
};
MatterVelocity disc_matter(const Spacetime& spacetime, double r, Sense sense = Sense::kEastward);

// The same at many radii: the innermost stable orbit is found once. spacetime: outlives this.
class DiscMatterFlow {
public:
    explicit DiscMatterFlow(const Spacetime& spacetime, Sense sense = Sense::kEastward);
    MatterVelocity at(double r) const;

private:
    const Spacetime& spacetime_;
    Sense sense_;
    std::optional<double> isco_;
    CircularOrbit last_{1, 0, 1, 0};
};

}  // namespace nullscope
