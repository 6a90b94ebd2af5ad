// Reissner-Nordstrom orbits by quadrature: (dzeta/dphi)^2 = P(zeta) = q^2 - zeta^2 + zeta^3 - kappa zeta^4, kappa = (Q/2M)^2.
//
// Every orbit is one or two monotone segments, each in a variable w in which its integrand is smooth:
//   from a turning point e, zeta = e -+ gamma sinh^2(w): P is expanded about e, so that nothing cancels there, and gamma is the
//       distance to the neighbouring root, so that nothing is steep next to the critical ray;
//   over the photon sphere, zeta = zeta_c + epsilon sinh(w): P = delta2 + (zeta - zeta_c)^2 g(zeta).
// Segments are cut into panels of 1/2 with 20 Gauss nodes. Roots are found in long double.
#include <array>
#include <limits>

#include "reference/potential_orbit.h"

namespace nullscope::reference {
namespace {

struct Charged {
    Long kappa, outer, inner;  // horizons, r
    Long sphere, stable;       // photon orbits, zeta
    Long q_crit, horizon;
    explicit Charged(double charge) {
        const Long q = charge, s = std::sqrt((1 - q) * (1 + q)), root = std::sqrt(1 + 8 * s * s);  // 9 - 32 kappa
        kappa = q * q / 4;
        outer = (1 + s) / 2;
        inner = kappa / outer;
        sphere = 4 / (3 + root);
        stable = (3 + root) / (8 * std::max(kappa, Long(1e-300L)));
        q_crit = sphere * std::sqrt(2 - sphere) / 2;
        horizon = 1 / outer;
    }
    bool has_circle() const { return true; }
    Long lapse2(Long r) const { return (1 - outer / r) * (1 - inner / r); }
    Long radius(Long r) const { return r; }
    Long fall_speed(Long r) const { return std::sqrt(r - kappa) / r; }  // below r = kappa the charge repels
    Long p(Long q, Long z) const { return (q - z) * (q + z) + z * z * (z - kappa * z * z); }
    // q_crit^2 - V = (zeta - sphere)^2 hill(zeta): by division with V'(sphere) = 0.
    Long below(Long x) const { return x * x * hill(sphere + x); }
    Long hill(Long z) const { return (2 - sphere) / 4 + z * ((1 / sphere - Long(0.5)) - kappa * z); }
    Long v_slope(Long z, Long off_sphere) const {  // off_sphere = sphere - z, given apart
        return 2 * z * (off_sphere / sphere) * (1 - z / stable);
    }
};

struct ChargedLeg : LegEnds {
    const Charged& hole;
    double q, kappa;
    ChargedLeg(const Charged& m, const PotentialStart& start, bool sky, Long nearest_root)
        : LegEnds{sky, nearest_root}, hole(m), q(static_cast<double>(start.q)), kappa(static_cast<double>(m.kappa)) {
        // Inside the horizon P has its last root, where rays turn above the inner horizon, next to where a camera may be.
        if (start.zeta0 * m.outer > 1) panel = kPanel / 64;
    }
    double sky_rate(double z) const { return 1 / std::sqrt(q * q - z * z * (1 + z * (kappa * z - 1))); }
};

// q < q_crit, from the turning point e, outside of the photon sphere or inside it: zeta = e + sign t, t = gamma sinh^2(w),
// P = t (c1 + c2 t + c3 t^2 + c4 t^3).
struct ChargedTurningLeg : ChargedLeg {
    double e, sign, gamma, log_zeta0;
    std::array<double, 4> c;
    ChargedTurningLeg(const Charged& m, const PotentialStart& start)
        : ChargedLeg(m, start, start.beyond < 0, 0), sign(to_sky ? -1 : 1) {
        const auto [turn_at, off] = turning_point(m, start);
        const int side = static_cast<int>(sign);
        const Long half = 1 - 3 * turn_at + 6 * m.kappa * turn_at * turn_at, third = -1 + 4 * m.kappa * turn_at;
        e = turn = static_cast<double>(turn_at);
        c = {static_cast<double>(-side * m.v_slope(turn_at, -off)), static_cast<double>(-half),
             static_cast<double>(-side * third), static_cast<double>(-m.kappa)};
        gamma = c[1] > 0 ? std::min(c[0] / c[1], e) : e;
        log_zeta0 = static_cast<double>(std::log(start.zeta0));
        nearest = to_sky ? turn_at : 0;
        camera = w_of_t(static_cast<double>(
            camera_distance(start, {turn_at, off}, side, [this](Long t) { return q_of(static_cast<double>(t)); })));
        end = w_of_t(static_cast<double>(to_sky ? turn_at : std::max(Long(0), m.horizon - turn_at)));
    }
    double q_of(double t) const { return c[0] + t * (c[1] + t * (c[2] + t * c[3])); }
    double t_of(double w) const { return gamma * std::sinh(w) * std::sinh(w); }
    double zeta(double w) const { return e + sign * t_of(w); }
    double w_of_t(double t) const { return std::asinh(std::sqrt(t / gamma)); }
    double root_p(double w) const { return std::sqrt(gamma) * std::sinh(w) * std::sqrt(q_of(t_of(w))); }
    double rate(double w) const { return 2 * std::sqrt(gamma) * std::cosh(w) / std::sqrt(q_of(t_of(w))); }
    double near_sky(double w) const {
        const double difference = 2 * std::cosh(0.5 * (end + w)) * std::sinh(0.5 * (end - w));  // of the two sinh
        return gamma * difference * (std::sinh(end) + std::sinh(w));
    }
    // 2 q dzeta / (zeta^2 A sqrt P) from the camera to the turning point; in log(zeta) far from it.
    double inward_delay() const {
        const double split = 0.5 * e, ro = static_cast<double>(hole.outer), ri = static_cast<double>(hole.inner);
        const auto weight = [=, this](double z) { return q / (z * z * (1 - ro * z) * (1 - ri * z)); };
        const auto near = [&](double w) { return rate(w) * weight(zeta(w)); };
        if (!(log_zeta0 < std::log(split))) return integrate_panels(near, 0, camera);
        const auto far = [&](double y) {
            const double z = std::exp(y);
            return z * weight(z) * sky_rate(z);
        };
        return integrate_panels(near, 0, w_of_t(e - split)) + integrate_panels(far, log_zeta0, std::log(split));
    }
};

// q > q_crit: zeta = sphere + epsilon sinh(w), P = delta2 + (zeta - sphere)^2 hill(zeta).
struct ChargedPassingLeg : ChargedLeg {
    double sphere, epsilon, delta2, h0, h1, h2;
    ChargedPassingLeg(const Charged& m, const PotentialStart& start)
        : ChargedLeg(m, start, start.s < 0, m.sphere),
          sphere(static_cast<double>(m.sphere)),
          delta2(static_cast<double>(start.delta2)) {
        h0 = static_cast<double>((2 - m.sphere) / 4), h1 = static_cast<double>(1 / m.sphere - Long(0.5));
        h2 = static_cast<double>(-m.kappa);
        epsilon = static_cast<double>(std::sqrt(start.delta2 / m.hill(m.sphere)));
        camera = w_of(start.beyond);
        end = w_of(to_sky ? -m.sphere : m.horizon - m.sphere);
    }
    double off(double w) const { return epsilon * std::sinh(w); }
    double zeta(double w) const { return sphere + off(w); }
    double w_of(Long off_sphere) const { return std::asinh(static_cast<double>(off_sphere) / epsilon); }
    double root_p(double w) const {
        const double x = off(w), z = sphere + x;
        return std::sqrt(delta2 + x * x * (h0 + z * (h1 + z * h2)));
    }
    double rate(double w) const { return epsilon * std::cosh(w) / root_p(w); }
    double near_sky(double w) const { return epsilon * 2 * std::cosh(0.5 * (w + end)) * std::sinh(0.5 * (w - end)); }
};

class ReissnerNordstrom : public PotentialMetric<Charged> {
    using PotentialMetric::PotentialMetric;
    std::unique_ptr<Orbit> swept(const PotentialStart& start) const override {
        if (start.delta2 > 0) return std::make_unique<LeggedOrbit<ChargedPassingLeg>>(hole_, start);
        return std::make_unique<LeggedOrbit<ChargedTurningLeg>>(hole_, start);
    }
};

}  // namespace

OrbitMetricPtr make_reissner_nordstrom_orbits(const SpacetimeSpec& spec) {
    const double charge = parameter_of(spec, "charge", 0.5);
    if (charge > 1.0) return make_naked_orbits(charge);
    return std::make_unique<ReissnerNordstrom>(Charged(charge));
}

}  // namespace nullscope::reference
