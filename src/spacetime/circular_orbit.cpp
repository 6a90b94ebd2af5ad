#include "spacetime/circular_orbit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "spacetime/axial_metric.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {
namespace {

constexpr double kFarthestStable = 1e6;  // r_s: from here inward the last stable orbit is looked for
constexpr double kLight = 1e-15;         // of g_tt: what is left of 1/(u^t)^2 on light's own orbit, roundings
constexpr double kInward = 0.98;         // of one radius that is looked at to the next
constexpr int kHalvings = 200;           // at most: the search ends where two radii are neighbours

std::optional<CircularOrbit> orbit_in(const Equator& e) {
    const double speed = std::sqrt(std::max(e.slope.tphi * e.slope.tphi - e.slope.tt * e.slope.phiphi, 0.0));
    const double omega = (speed - e.slope.tphi) / e.slope.phiphi;
    const double rest2 = -e.g.tt - (2.0 * e.g.tphi + e.g.phiphi * omega) * omega;
    if (!(rest2 > kLight * std::fabs(e.g.tt) && e.across2 > 0.0)) return std::nullopt;
    const double u_t = 1.0 / std::sqrt(rest2);
    return CircularOrbit{u_t, omega, -u_t * (e.g.tt + e.g.tphi * omega), u_t * (e.g.tphi + e.g.phiphi * omega)};
}

// phi counted in that sense.
Equator seen_in(Sense sense, Equator e) {
    if (sense == Sense::kWestward)
        for (Equator::Components* of : {&e.g, &e.slope, &e.curvature}) of->tphi = -of->tphi;
    return e;
}

bool pulled_outward(const Equator& e) { return e.slope.tphi * e.slope.tphi < e.slope.tt * e.slope.phiphi; }

bool stable(const Equator& e) {
    const auto orbit = orbit_in(e);
    if (!orbit || pulled_outward(e)) return false;
    const double energy = orbit->energy, momentum = orbit->momentum;
    const auto &g = e.g, &first = e.slope, &second = e.curvature;
    const double bend = energy * energy * second.phiphi + 2.0 * energy * momentum * second.tphi +
                        momentum * momentum * second.tt,
                 across2 = 2.0 * (first.tphi * first.tphi + g.tphi * second.tphi - first.tt * first.phiphi) -
                           second.tt * g.phiphi - g.tt * second.phiphi;
    return bend < across2;
}

// Halves (inside, outside) in 1/r; is(r): is it outside?
template <class Is>
std::array<double, 2> divided(double inside_r, const Is& is, double outside_r = kFarthestStable) {
    double outside = 1.0 / outside_r, inside = 1.0 / inside_r;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (outside + inside);
        if (middle <= outside || middle >= inside) break;
        (is(1.0 / middle) ? outside : inside) = middle;
    }
    return {outside, inside};
}

}  // namespace

std::optional<CircularOrbit> circular_orbit(const Spacetime& spacetime, double r, Sense sense) {
    if (const auto horizon = spacetime.horizon_radius(); horizon && r <= *horizon)
        return {};  // within an inner one there are some
    const auto equator = spacetime.equator(r);
    auto orbit = equator && !pulled_outward(*equator) ? orbit_in(seen_in(sense, *equator)) : std::nullopt;
    if (orbit) orbit->omega *= sign_of(sense), orbit->momentum *= sign_of(sense);
    return orbit;
}

bool has_circular_rate_numbers(const Spacetime& spacetime) {
    return spacetime.rotates() || !spacetime.bends_light() || spacetime.spherical()->lapse_roots().has_value();
}

std::array<double, 2> circular_rate_numbers(const Spacetime& spacetime) {
    if (const AxialMetric* axial = spacetime.axial()) return {0.5, axial->charge2()};
    const LapseRoots roots = spacetime.spherical()->lapse_roots().value_or(LapseRoots{0, 0});
    return {0.5 * (roots.outer + roots.inner), roots.outer * roots.inner};
}

double circular_rate_scaled(const Spacetime& spacetime, double r) {
    const auto e = spacetime.equator(r);
    return e ? -e->slope.tt / e->slope.phiphi * r * r * r : 0.0;
}

double light_orbit(const Spacetime& spacetime, Sense sense) {
    const auto has_orbit = [&](double r) {
        const auto equator = spacetime.equator(r);
        return equator && orbit_in(seen_in(sense, *equator));
    };
    return 1.0 / divided(*spacetime.horizon_radius(), has_orbit)[1];
}

double innermost_light_orbit(const Spacetime& spacetime) {
    return std::min(light_orbit(spacetime, Sense::kEastward), light_orbit(spacetime, Sense::kWestward));
}

std::optional<double> innermost_stable_orbit(const Spacetime& spacetime, Sense sense) {
    const auto sphere = spacetime.photon_sphere();
    const auto least = sphere ? sphere->radius : spacetime.horizon_radius();
    if (!least || !spacetime.equator(*least)) return std::nullopt;
    const auto is_stable = [&](double r) { return stable(seen_in(sense, *spacetime.equator(r))); };
    // Where a cosmological constant pulls outward, there are none far out, or none at all.
    double from = kFarthestStable;
    while (from > *least && !is_stable(from)) from *= kInward;
    if (!(from > *least)) return std::nullopt;
    const auto [outside, inside] = divided(*least, is_stable, from);
    return 2.0 / (outside + inside);
}

double outermost_circular_orbit(const Spacetime& spacetime) {
    const auto sphere = spacetime.photon_sphere();
    const auto pulled = [&](double r) {
        const auto equator = spacetime.equator(r);
        return equator && pulled_outward(*equator);
    };
    return sphere && pulled(kFarthestStable) ? 1.0 / divided(sphere->radius, pulled)[1] : kAnyRadius;
}

DiscMatterFlow::DiscMatterFlow(const Spacetime& spacetime, Sense sense)
    : spacetime_(spacetime), sense_(sense), isco_(innermost_stable_orbit(spacetime, sense)) {
    if (isco_) last_ = *circular_orbit(spacetime, *isco_, sense);
}

MatterVelocity DiscMatterFlow::at(double r) const {
    if (!isco_ || r >= *isco_) {
        const CircularOrbit orbit = circular_orbit(spacetime_, r, sense_).value_or(CircularOrbit{1, 0, 1, 0});
        return {orbit.u_t, 0.0, orbit.u_t * orbit.omega};
    }
    const double energy = last_.energy, momentum = last_.momentum;
    const Equator e = *spacetime_.equator(r);
    const double n = energy * energy * e.g.phiphi + 2.0 * energy * momentum * e.g.tphi + momentum * momentum * e.g.tt;
    return {(energy * e.g.phiphi + momentum * e.g.tphi) / e.across2,
            -std::sqrt(std::max(n - e.across2, 0.0) / e.radial), -(energy * e.g.tphi + momentum * e.g.tt) / e.across2};
}

MatterVelocity disc_matter(const Spacetime& spacetime, double r, Sense sense) {
    return DiscMatterFlow(spacetime, sense).at(r);
}

}  // namespace nullscope
