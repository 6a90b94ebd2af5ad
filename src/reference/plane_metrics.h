// The metrics whose rays stay in a plane, one a file NAME_orbit.cpp, and what their orbits share.
#pragma once
#include <fmt/format.h>

#include <limits>
#include <memory>

#include "reference/orbit.h"

namespace nullscope::reference {

using OrbitMetricPtr = std::unique_ptr<OrbitMetric>;

OrbitMetricPtr make_schwarzschild_orbits(const SpacetimeSpec& spec);
OrbitMetricPtr make_reissner_nordstrom_orbits(const SpacetimeSpec& spec);  // above charge 1 the naked ones
OrbitMetricPtr make_naked_orbits(double charge);
OrbitMetricPtr make_janis_newman_winicour_orbits(const SpacetimeSpec& spec);
OrbitMetricPtr make_star_orbits(const SpacetimeSpec& spec);
OrbitMetricPtr make_ellis_orbits(const SpacetimeSpec& spec);
OrbitMetricPtr make_dneg_orbits(const SpacetimeSpec& spec);
Result<std::unique_ptr<Metric>> make_formula_orbits(const SpacetimeSpec& spec);  // errors: formulas without a hole
OrbitMetricPtr make_minkowski_orbits(const SpacetimeSpec& spec);

using Long = long double;
// How far below zero q^2 - V(zeta0) may lie, relative to q^2, and still be a turning point whose inputs were rounded.
inline constexpr double kTurningSlack = 16 * std::numeric_limits<double>::epsilon();
// q^2 - q_crit^2 that stands for that of the critical ray, which never ends: closer than any double q comes.
inline constexpr double kNearlyCritical2 =
    std::numeric_limits<double>::epsilon() * std::numeric_limits<double>::epsilon();

// from_reduced() where it lies further below. why: of the message.
inline Error no_such_ray(const ReducedRay& ray, const char* place, const char* why = "") {
    return bad_input(
        fmt::format("no ray with q = {:.17g} passes through {} = {:.17g}{}", ray.q, place, ray.zeta0, why));
}

// Along the radius, in or out, or (no radial one) for ever at one place, zeta or l: the circles of light.
class StandingOrbit final : public Orbit {
public:
    StandingOrbit(double place, Fate fate, bool radial = true) : Orbit(place), radial_(radial) {
        fate_ = fate;
        if (radial && fate != Fate::kNoSky) angle_ = 0;
    }
    double zeta_at(double angle) const override { return angle == 0 || !radial_ ? place_ : kNotANumber; }
    double delay() const override { return fate_ == Fate::kEscaped || fate_ == Fate::kOtherSide ? 0 : kNotANumber; }

private:
    double place_at(double) const override { return kNotANumber; }
    bool radial_;
};

// The frame of what falls from rest at infinity, w = sqrt(1 - A): E = 1 + w n_r, and dr along the traced ray goes as w
// + n_r. Where n_r < 0 both are sums of 1 + n_r = n_t^2/(1 - n_r) and of -depth = 1 - w = A/(1 + w).
template <class Real>
struct RainStart {
    Real energy, outward;
    RainStart(const LocalRay& ray, Real w, Real depth) : energy(1 + w * ray.n_r), outward(w + ray.n_r) {
        if (!(ray.n_r < 0)) return;
        const Real n_r = ray.n_r, tilt = Real(ray.n_t) * ray.n_t / (1 - n_r);
        energy = tilt + n_r * depth;
        outward = tilt + depth;
    }
};

// At a camera in a wormhole. turn2 = b^2 - rho^2 and away2 = R^2 - b^2 >= 0 do not follow from l and b in double.
struct ThroatStart {
    Long l, b;
    bool outward;  // towards growing l
    Long turn2, away2;
};
inline bool outward(const ReducedRay& ray) { return (ray.s < 0) == (ray.zeta0 >= 0); }  // s = +1: towards the throat

// rho: the throat's radius, in a unit of length like start; swept(start): the orbit of a ray that is not radial and ends.
template <class Swept>
std::unique_ptr<Orbit> orbit_through_throat(ThroatStart start, Long rho, double unit, const Swept& swept) {
    const double l = unit * static_cast<double>(start.l);
    if (start.b < 1e-60 * rho)
        return std::make_unique<StandingOrbit>(l, start.outward ? Fate::kEscaped : Fate::kOtherSide);
    if (start.turn2 == 0 && start.away2 == 0) return std::make_unique<StandingOrbit>(l, Fate::kNoSky, false);
    if (start.turn2 == 0) start.turn2 = -kNearlyCritical2 * rho * rho;
    return swept(start);
}

}  // namespace nullscope::reference
