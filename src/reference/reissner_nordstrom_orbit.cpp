// Reissner-Nordstrom orbits by quadrature: (dzeta/dphi)^2 = P(zeta) = q^2 - zeta^2 + zeta^3 - kappa zeta^4, kappa = (Q/2M)^2.
//
// Every orbit is one or two monotone legs, each in a variable w in which its integrand is smooth:
//   from a turning point e, zeta = e -+ gamma sinh^2(w): P is expanded about e, so that nothing cancels there, and gamma is the
//       distance to the neighbouring root, so that nothing is steep next to the critical ray;
//   over the photon sphere, zeta = zeta_c + epsilon sinh(w): P = delta2 + (zeta - zeta_c)^2 g(zeta).
// Legs are cut into panels of 1/2 with 20 Gauss nodes. Roots are found in long double.
#include <array>
#include <limits>

#include "reference/plane_metrics.h"
#include "reference/smooth_leg.h"

namespace nullscope::reference {
namespace {

constexpr double kRadialQ = 1e60, kLeastQ = 1e-60;  // beyond: radial; below: the regular limit

struct Charged {
    Long kappa, outer, inner;  // horizons, r
    Long sphere, stable;       // photon orbits, zeta
    Long q_crit;
    explicit Charged(double charge) {
        const Long q = charge, s = std::sqrt((1 - q) * (1 + q)), root = std::sqrt(1 + 8 * s * s);  // 9 - 32 kappa
        kappa = q * q / 4;
        outer = (1 + s) / 2;
        inner = kappa / outer;
        sphere = 4 / (3 + root);
        stable = (3 + root) / (8 * std::max(kappa, Long(1e-300L)));
        q_crit = sphere * std::sqrt(2 - sphere) / 2;
    }
    Long lapse2(Long r) const { return (1 - outer / r) * (1 - inner / r); }
    Long v(Long z) const { return z * z * (1 - outer * z) * (1 - inner * z); }
    // q_crit^2 - V = (zeta - sphere)^2 hill(zeta): by division with V'(sphere) = 0.
    Long hill(Long z) const { return (2 - sphere) / 4 + z * ((1 / sphere - Long(0.5)) - kappa * z); }
    Long v_slope(Long z, Long off_sphere) const {  // off_sphere = sphere - z, given apart
        return 2 * z * (off_sphere / sphere) * (1 - z / stable);
    }
};

// At the camera. root_p = sqrt(P), delta2 = q^2 - q_crit^2 and beyond = zeta0 - sphere do not follow from q and zeta0 in double.
struct Start {
    Long q, zeta0;
    int s;  // +1 towards the hole
    Long root_p, delta2, beyond;
};

// From the turning point e: zeta = e + sign t, P = t (c1 + c2 t + c3 t^2 + c4 t^3), t = gamma sinh^2(w).
struct TurningLeg {
    double e, sign, gamma;
    std::array<double, 4> c;
    TurningLeg(const Charged& m, Long turn, Long off_sphere, int side) : e(static_cast<double>(turn)), sign(side) {
        const Long half = 1 - 3 * turn + 6 * m.kappa * turn * turn, third = -1 + 4 * m.kappa * turn;
        c = {static_cast<double>(-side * m.v_slope(turn, off_sphere)), static_cast<double>(-half),
             static_cast<double>(-side * third), static_cast<double>(-m.kappa)};
        gamma = c[1] > 0 ? std::min(c[0] / c[1], e) : e;
    }
    double q_of(double t) const { return c[0] + t * (c[1] + t * (c[2] + t * c[3])); }
    double t_of(double w) const { return gamma * std::sinh(w) * std::sinh(w); }
    double zeta(double w) const { return e + sign * t_of(w); }
    double w_of_t(double t) const { return std::asinh(std::sqrt(t / gamma)); }
    double root_p(double w) const { return std::sqrt(gamma) * std::sinh(w) * std::sqrt(q_of(t_of(w))); }
    double rate(double w) const { return 2 * std::sqrt(gamma) * std::cosh(w) / std::sqrt(q_of(t_of(w))); }  // dphi/dw
    // t of the camera: P = t Q(t) with sqrt(P) given keeps the digits that zeta0 - e has lost.
    double camera_t(Long zeta0, Long turn, Long root) const {
        double t = static_cast<double>(std::max(Long(0), sign * (zeta0 - turn)));
        for (int i = 0; i < 40 && t < 0.1 * e; ++i) t = static_cast<double>(root * root / Long(q_of(t)));
        return t;
    }
};

// q > q_crit: zeta = sphere + epsilon sinh(w), P = delta2 + (zeta - sphere)^2 hill(zeta).
struct PassingLeg {
    double sphere, epsilon, delta2, h0, h1, h2;
    PassingLeg(const Charged& m, Long delta)
        : sphere(static_cast<double>(m.sphere)), delta2(static_cast<double>(delta)) {
        h0 = static_cast<double>((2 - m.sphere) / 4), h1 = static_cast<double>(1 / m.sphere - Long(0.5));
        h2 = static_cast<double>(-m.kappa);
        epsilon = static_cast<double>(std::sqrt(delta / m.hill(m.sphere)));
    }
    double off(double w) const { return epsilon * std::sinh(w); }
    double zeta(double w) const { return sphere + off(w); }
    double w_of(Long off_sphere) const { return std::asinh(static_cast<double>(off_sphere) / epsilon); }
    double root_p(double w) const {
        const double x = off(w), z = sphere + x;
        return std::sqrt(delta2 + x * x * (h0 + z * (h1 + z * h2)));
    }
    double rate(double w) const { return epsilon * std::cosh(w) / root_p(w); }
};

// Between the sky and a camera at less than a quarter of the nearest root, where P stays near q^2: zeta itself is the variable,
// so that angles of any smallness keep their digits.
struct SkyLeg {
    double q, zeta0, kappa;
    bool used;
    SkyLeg(const Charged& m, const Start& start, Long nearest)
        : q(static_cast<double>(start.q)),
          zeta0(static_cast<double>(start.zeta0)),
          kappa(static_cast<double>(m.kappa)),
          used(start.s < 0 && start.zeta0 < nearest / 4) {}
    double root_p(double z) const { return std::sqrt(q * q - z * z * (1 + z * (kappa * z - 1))); }
    double rate(double z) const { return 1 / root_p(z); }
    double angle() const {
        return integrate_panels([this](double z) { return rate(z); }, 0, zeta0);
    }
    double delay() const {
        return integrate_panels([this](double z) { return rate(z) / (q + root_p(z)); }, 0, zeta0);
    }
    double zeta(double rest) const {
        return invert_panels([this](double z) { return rate(z); }, 0, zeta0, rest);
    }
};

// T of an outward leg from the sky: dphi / (q + sqrt P).
template <class Leg>
double outward_delay(const Leg& leg, double q, double sky, double camera, double panel = kPanel) {
    return integrate_panels([&](double w) { return leg.rate(w) / (q + leg.root_p(w)); }, sky, camera, panel);
}

// Inside the horizon P has its last root, where rays turn above the inner horizon, next to where a camera may be.
double panel_of(const Charged& m, const Start& start) { return start.zeta0 * m.outer > 1 ? kPanel / 64 : kPanel; }

class Turning : public Orbit {  // q < q_crit: outside the photon sphere up to e2, or inside it down to e3
public:
    Turning(const Charged& m, const Start& start)
        : metric_(m),
          start_(start),
          outside_(start.beyond < 0),
          turning_(find_turn(m, start, outside_)),
          leg_(m, turning_.zeta, -turning_.off, outside_ ? -1 : 1),
          sky_(m, start, outside_ ? turning_.zeta : 0),
          panel_(panel_of(m, start)) {
        camera_ = leg_.w_of_t(leg_.camera_t(start.zeta0, turning_.zeta, start.root_p));
        const Long end_t = outside_ ? turning_.zeta : std::max(Long(0), 1 / m.outer - turning_.zeta);
        end_ = leg_.w_of_t(static_cast<double>(end_t));
        const bool inside_horizon = start.zeta0 * m.outer >= 1;
        const bool meets_turn = outside_ == (start.s > 0);
        if (!outside_ && inside_horizon && start.s > 0) return;  // falls from the start
        fate_ = outside_ ? Fate::kEscaped : inside_horizon ? Fate::kNoSky : Fate::kCaptured;
        const auto rate = [this](double w) { return leg_.rate(w); };
        if (meets_turn) {
            turn_ = static_cast<double>(turning_.zeta);
            to_turn_ = integrate_panels(rate, 0, camera_, panel_);
            angle_ = to_turn_ + integrate_panels(rate, 0, end_);
        } else {
            angle_ = sky_.used ? sky_.angle() : integrate_panels(rate, camera_, end_, panel_);
        }
    }
    double zeta_at(double angle) const override {
        if (angle == 0) return static_cast<double>(start_.zeta0);
        if (has_ended(angle)) return kNotANumber;
        if (sky_.used) return sky_.zeta(angle_ - angle);
        const auto rate = [this](double w) { return leg_.rate(w); };
        if (angle < to_turn_) return leg_.zeta(invert_panels(rate, camera_, 0, -angle, panel_));
        const double from = turn_ == turn_ ? 0 : camera_;
        // From the nearer end: next to the sky zeta is small, and its digits count from there.
        if (angle_ - angle < 0.5 * (angle_ - to_turn_)) {
            const double w = invert_panels(rate, end_, from, angle - angle_, panel_);
            return outside_ ? near_sky(w) : leg_.zeta(w);
        }
        return leg_.zeta(invert_panels(rate, from, end_, angle - to_turn_, panel_));
    }
    double delay() const override {
        if (fate_ != Fate::kEscaped) return kNotANumber;
        if (sky_.used) return sky_.delay();
        const double out = outward_delay(leg_, static_cast<double>(start_.q), camera_, end_);
        return start_.s > 0 ? out + 2 * inward_delay() : out;
    }

private:
    struct Turn {
        Long zeta, off;  // off = zeta - sphere
    };
    // d sqrt(hill(sphere -+ d)) = sqrt(-delta2); far below the critical q, zeta sqrt(A) = q instead.
    static Turn find_turn(const Charged& m, const Start& start, bool outside) {
        const Long wanted = std::sqrt(-start.delta2), q = start.q;
        if (outside && q < m.q_crit / 2) {
            Long e = q;
            for (int i = 0; i < 60; ++i) {
                const Long root = std::sqrt((1 - m.outer * e) * (1 - m.inner * e));
                const Long next = e - (e * root - q) * root / (m.v_slope(e, m.sphere - e) / (2 * e));
                if (std::abs(next - e) <= 1e-19L * e) break;
                e = next;
            }
            return {e, e - m.sphere};
        }
        const Long side = outside ? -1 : 1, most = outside ? m.sphere : 1 / m.outer - m.sphere;
        Long low = 0, high = most, d = std::min(most, wanted / std::sqrt(m.hill(m.sphere)));
        for (int i = 0; i < 200; ++i) {
            const Long z = m.sphere + side * d, root = std::sqrt(std::max(m.hill(z), Long(0)));
            const Long f = d * root - wanted;
            (f > 0 ? high : low) = d;
            const Long slope = root + d * side * ((1 / m.sphere - Long(0.5)) - 2 * m.kappa * z) / (2 * root);
            Long next = d - f / slope;
            if (!(next >= low && next <= high)) next = (low + high) / 2;
            if (std::abs(next - d) <= 1e-19L * d) break;
            d = next;
        }
        return {m.sphere + side * d, side * d};
    }
    // zeta = integral from the sky is e - t with t near e: as the root difference it keeps its digits.
    double near_sky(double w) const {
        const double we = end_, a = std::sinh(we), b = std::sinh(w);
        const double difference = 2 * std::cosh(0.5 * (we + w)) * std::sinh(0.5 * (we - w));  // a - b
        return leg_.gamma * difference * (a + b);
    }
    // 2 q dzeta / (zeta^2 A sqrt P) from the camera to the turning point; in log(zeta) far from it.
    double inward_delay() const {
        const double q = static_cast<double>(start_.q), e = leg_.e, split = 0.5 * e,
                     kappa = static_cast<double>(metric_.kappa);
        const double ro = static_cast<double>(metric_.outer), ri = static_cast<double>(metric_.inner);
        const auto weight = [=](double z) { return q / (z * z * (1 - ro * z) * (1 - ri * z)); };
        const auto near = [&](double w) { return leg_.rate(w) * weight(leg_.zeta(w)); };
        if (start_.zeta0 >= split) return integrate_panels(near, 0, camera_);
        const auto far = [=](double y) {
            const double z = std::exp(y);
            return z * weight(z) / std::sqrt(q * q - z * z * (1 + z * (kappa * z - 1)));
        };
        return integrate_panels(near, 0, leg_.w_of_t(e - split)) +
               integrate_panels(far, static_cast<double>(std::log(start_.zeta0)), std::log(split));
    }
    Charged metric_;
    Start start_;
    bool outside_;
    Turn turning_;
    TurningLeg leg_;
    SkyLeg sky_;
    double panel_, camera_ = 0, end_ = 0, to_turn_ = 0;
};

class Passing : public Orbit {  // q > q_crit: monotone over the photon sphere
public:
    Passing(const Charged& m, const Start& start)
        : start_(start), leg_(m, start.delta2), sky_(m, start, m.sphere), panel_(panel_of(m, start)) {
        camera_ = leg_.w_of(start.beyond);
        const bool out = start.s < 0, inside_horizon = start.zeta0 * m.outer >= 1;
        if (!out && inside_horizon) return;
        end_ = leg_.w_of(out ? -m.sphere : 1 / m.outer - m.sphere);
        fate_ = out ? Fate::kEscaped : Fate::kCaptured;
        angle_ = sky_.used
                     ? sky_.angle()
                     : std::abs(integrate_panels([this](double w) { return leg_.rate(w); }, camera_, end_, panel_));
    }
    double zeta_at(double angle) const override {
        if (angle == 0) return static_cast<double>(start_.zeta0);
        if (has_ended(angle)) return kNotANumber;
        if (sky_.used) return sky_.zeta(angle_ - angle);
        const auto rate = [this](double w) { return leg_.rate(w); };
        const double sign = start_.s > 0 ? 1 : -1;
        if (start_.s < 0 && angle_ - angle < 0.5 * angle_) {
            const double w = invert_panels(rate, end_, camera_, angle_ - angle, panel_);
            return leg_.epsilon * 2 * std::cosh(0.5 * (w + end_)) * std::sinh(0.5 * (w - end_));
        }
        return leg_.zeta(invert_panels(rate, camera_, end_, sign * angle, panel_));
    }
    double delay() const override {
        if (fate_ != Fate::kEscaped) return kNotANumber;
        return sky_.used ? sky_.delay() : outward_delay(leg_, static_cast<double>(start_.q), end_, camera_, panel_);
    }

private:
    Start start_;
    PassingLeg leg_;
    SkyLeg sky_;
    double panel_, camera_ = 0, end_ = 0;
};

class ReissnerNordstrom : public OrbitMetric {
public:
    explicit ReissnerNordstrom(double charge) : m_(charge) {}
    std::optional<double> horizon_radius() const override { return static_cast<double>(m_.outer); }
    double lapse(double r) const override { return std::sqrt(static_cast<double>(m_.lapse2(r))); }
    Result<std::unique_ptr<Orbit>> from_reduced(const ReducedRay& ray) const override {
        const Long q = std::max(ray.q, kLeastQ), zeta0 = ray.zeta0;
        Long p = 0, delta2 = 0;
        if (ray.q < kRadialQ) {
            p = (q - zeta0) * (q + zeta0) + zeta0 * zeta0 * (zeta0 - m_.kappa * zeta0 * zeta0);
            delta2 = (q - m_.q_crit) * (q + m_.q_crit);
            if (p < -kTurningSlack * q * q) return no_such_ray(ray, "zeta0", ": q^2 < V(zeta0)");
        }
        return orbit({q, zeta0, ray.s, std::sqrt(std::max(p, Long(0))), delta2, zeta0 - m_.sphere});
    }
    std::unique_ptr<Orbit> from_static(const LocalRay& ray) const override {
        const Long root_v = std::sqrt(m_.lapse2(ray.r)) / ray.r;
        return local(ray.r, root_v / ray.n_t, root_v / ray.n_t * std::abs(ray.n_r), ray.n_r <= 0 ? 1 : -1);
    }
    // w = sqrt(1 - A) = sqrt((r - kappa)/r^2): nothing falls from infinity below r = kappa, where the charge repels.
    RainOrbit from_rain(const LocalRay& ray) const override {
        const Long r = ray.r;
        if (!(r >= m_.kappa)) return {std::make_unique<StandingOrbit>(1 / ray.r, Fate::kNoSky), kNotANumber};
        const Long w = std::sqrt(r - m_.kappa) / r;
        const auto [energy, outward] = RainStart<Long>(ray, w, -m_.lapse2(r) / (1 + w));
        if (!(energy > 0)) return {std::make_unique<StandingOrbit>(1 / ray.r, Fate::kNoSky), kNotANumber};
        return {local(r, energy / (r * ray.n_t), std::abs(outward) / (r * ray.n_t), outward > 0 ? -1 : 1),
                static_cast<double>(1 / energy)};
    }

private:
    std::unique_ptr<Orbit> local(Long r, Long q, Long root_p, int s) const {
        Start start{q, 1 / r, s, root_p, 0, (1 / m_.sphere - r) / (r / m_.sphere)};
        const Long hill = std::abs(start.beyond) * std::sqrt(std::max(m_.hill(1 / r), Long(0)));
        const bool near = root_p * root_p + hill * hill < m_.q_crit * m_.q_crit / 4;
        start.delta2 = near ? (root_p - hill) * (root_p + hill) : (q - m_.q_crit) * (q + m_.q_crit);
        return orbit(start);
    }
    std::unique_ptr<Orbit> orbit(Start start) const {
        const bool inside = start.zeta0 * m_.outer >= 1;
        if (!(start.q < kRadialQ))
            return std::make_unique<StandingOrbit>(static_cast<double>(start.zeta0),
                                                   start.s < 0 ? Fate::kEscaped
                                                   : inside    ? Fate::kNoSky
                                                               : Fate::kCaptured,
                                                   true);
        if (start.delta2 == 0 && start.root_p == 0)
            return std::make_unique<StandingOrbit>(static_cast<double>(start.zeta0), Fate::kNoSky, false);
        // The critical ray itself never ends; its neighbour, closer than any double q comes, does.
        if (start.delta2 == 0) start.delta2 = std::pow(Long(std::numeric_limits<double>::epsilon()), 2);
        if (start.delta2 > 0) return std::make_unique<Passing>(m_, start);
        return std::make_unique<Turning>(m_, start);
    }
    Charged m_;
};

}  // namespace

OrbitMetricPtr make_reissner_nordstrom_orbits(const SpacetimeSpec& spec) {
    const double charge = parameter_of(spec, "charge", 0.5);
    if (charge > 1.0) return make_naked_orbits(charge);
    return std::make_unique<ReissnerNordstrom>(charge);
}

}  // namespace nullscope::reference
