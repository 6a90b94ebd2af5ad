// Orbits about a hole given by formulas, by quadrature of dphi = sqrt(A B) (r/R)^2 dzeta/sqrt(q^2 - V), V = A/R^2, zeta = 1/r.
//
// Every orbit is one or two monotone segments, each in a variable w in which its integrand is smooth:
//   from a turning point e, zeta = e -+ gamma sinh^2(w): q^2 - V = t times the mean of V' over t, gamma the distance to the neighbouring
//       root as the first two derivatives at e tell it;
//   over the photon sphere, zeta = zeta_c + epsilon sinh(w): q^2 - V = delta2 + below(zeta - zeta_c);
//   next to the sky zeta itself.
// Panels of w with 20 Gauss nodes; formulas in long double, so that differences of V lose nothing that a double has.
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "expr/smooth.h"
#include "reference/potential_orbit.h"

namespace nullscope::reference {
namespace {

// What the reference knows of a hole that scene files give by formulas: A, B and R in long double, and the places that its orbits need.
struct FormulaHole {
    expr::SmoothFormula a;
    std::optional<expr::SmoothFormula> b, areal;
    Long horizon = 0, sphere = 0;  // zeta
    Long v_crit = 0, q_crit = 0;   // V at the photon sphere
    Long outermost_circle = 0;     // r up to which the energy of circles grows, or 100 horizons

    // Errors: a formula that cannot be read, no horizon.
    static Result<FormulaHole> of(const SpacetimeSpec& spec);

    Long lapse2(Long r) const { return a.value<Long>(r); }
    Long radius(Long r) const { return areal ? areal->value<Long>(r) : r; }
    Long fall_speed(Long r) const {
        return std::sqrt(1 - lapse2(r));
    }  // from rest at infinity; not a number: it repels
    bool has_circle() const { return true; }
    Long v(Long zeta) const;
    Long p(Long q, Long zeta) const { return q * q - v(zeta); }
    Long v_slope(Long zeta) const;  // by zeta
    Long v_bend(Long zeta) const;   // twice
    Long density(Long zeta) const;  // dphi = density dzeta/sqrt(q^2 - V)
    // V(turn) - V(turn + by) over by: the mean of -V' between. v_turn = V(turn).
    Long mean_fall(Long turn, Long v_turn, Long by) const;
    // v_crit - V(sphere + x): twice integrated, -x^2 times the mean of (1 - u) V'', where V is too near to its maximum for a difference.
    Long below(Long x) const;
};

constexpr Long kLeastZeta = 1e-200L;  // stands for the sky: powers of r up to 24 are still numbers there

template <int n>
using Jet = expr::Series<Long, n>;
using Rule = boost::math::quadrature::gauss<Long, 10>;

constexpr Long kNear = 1e-6L;  // of V, below which differences of V have lost six digits of a long double's nineteen

template <int n>
Jet<n> v_jet(const FormulaHole& hole, Long zeta) {
    const Jet<n> r = Jet<n>(Long(1)) / Jet<n>::variable(zeta);
    const Jet<n> across = hole.areal ? hole.areal->value<Long>(r) : r;
    return hole.a.value<Long>(r) / (across * across);
}

// Energy of a circle: A/sqrt(A - r A'/2); nothing inside light's. Where nothing is held by gravity: at rest.
std::optional<Long> circle_energy(const FormulaHole& hole, Long r) {
    const Jet<2> lapse2 = hole.a.value<Long>(Jet<2>::variable(r));
    const Long part = lapse2[0] - std::max(r * lapse2[1], Long(0)) / 2;
    if (!(part > 0 && lapse2[0] > 0)) return std::nullopt;
    return lapse2[0] / std::sqrt(part);
}

// Outward from the photon sphere the energy falls to the last stable circle and grows from there on; with a cosmological constant it
// falls again further out.
Long outermost_circle_of(const FormulaHole& hole) {
    constexpr Long kStep = 1.02L;
    const Long most = 100 / hole.horizon;
    Long r = 1.02L / hole.sphere, before = std::numeric_limits<Long>::infinity();
    bool grows = false;
    for (; r < most; r *= kStep) {
        const auto energy = circle_energy(hole, r);
        if (!energy) continue;
        if (grows && *energy < before) break;
        grows = *energy > before;
        before = *energy;
    }
    return std::min(r, most);
}

Result<FormulaHole> FormulaHole::of(const SpacetimeSpec& spec) {
    FormulaHole hole;
    const auto text = [&](const std::string& name) {
        const auto found = spec.parameters.formulas.find(name);
        return found == spec.parameters.formulas.end() ? std::string() : found->second;
    };
    TRY(a, expr::SmoothFormula::parse(text("A").empty() ? "1 - 1/r" : text("A"), "r"));
    hole.a = *a;
    for (const auto& [name, formula] : {std::pair{"B", &hole.b}, {"R", &hole.areal}}) {
        if (text(name).empty()) continue;
        TRY(parsed, expr::SmoothFormula::parse(text(name), "r"));
        *formula = *parsed;
    }
    // Inward from where observers rest to where they do no more, which may be between two looks: about the least A there.
    const auto lapse2 = [&](Long r) { return hole.lapse2(r); };
    const auto rise = [&](Long r) { return hole.a.value<Long>(Jet<2>::variable(r))[1]; };
    constexpr Long kLook = 0.995L;
    Long rest = 0;  // the last r where they do
    for (Long r = 1e6L; r > 1e-3L && hole.horizon == 0; r *= kLook) {
        const bool turned = rise(r) * rise(r / kLook) < 0;
        for (const Long at : {turned ? root_of(rise, r, r / kLook, 63) : r, r}) {
            if (rest > 0 && !(lapse2(at) > 0) && hole.horizon == 0) hole.horizon = 1 / root_of(lapse2, at, rest, 63);
            if (lapse2(at) > 0) rest = at;
        }
    }
    if (hole.horizon == 0) return bad_input("the formulas give no horizon");
    // Outward from the horizon, where V falls outside it: to the last place before it does not grow any more.
    const auto slope = [&](Long zeta) { return hole.v_slope(zeta); };
    Long zeta = hole.horizon;
    while (zeta > 1e-6L && !(slope(zeta) > 0)) zeta *= 0.99L;
    hole.sphere = root_of(slope, zeta, zeta / 0.99L, 63);
    hole.v_crit = hole.v(hole.sphere);
    hole.q_crit = std::sqrt(hole.v_crit);
    hole.outermost_circle = outermost_circle_of(hole);
    return hole;
}

Long FormulaHole::v(Long zeta) const {
    const Long r = 1 / std::max(zeta, kLeastZeta), across = radius(r);
    return lapse2(r) / (across * across);
}
Long FormulaHole::v_slope(Long zeta) const { return v_jet<2>(*this, zeta).of_power(1); }
Long FormulaHole::v_bend(Long zeta) const { return 2 * v_jet<3>(*this, zeta).of_power(2); }

Long FormulaHole::density(Long zeta) const {
    if (!b && !areal) return 1;
    const Long r = 1 / std::max(zeta, kLeastZeta), part = r / radius(r);
    return std::sqrt(b ? lapse2(r) * b->value<Long>(r) : Long(1)) * part * part;
}

Long FormulaHole::mean_fall(Long turn, Long v_turn, Long by) const {
    const Long fall = v_turn - v(turn + by);
    if (std::abs(fall) > kNear * v_turn) return fall / by;
    return -Rule::integrate([&](Long u) { return v_slope(turn + u * by); }, Long(0), Long(1));
}

Long FormulaHole::below(Long x) const {
    const Long whole = v_crit - v(sphere + x);
    if (whole > kNear * v_crit) return whole;
    return -x * x * Rule::integrate([&](Long u) { return (1 - u) * v_bend(sphere + u * x); }, Long(0), Long(1));
}

class FormulaLeg : public LegEnds {
public:
    double sky_rate(double z) const { return static_cast<double>(hole_.density(z) / std::sqrt(q_ * q_ - hole_.v(z))); }

protected:
    FormulaLeg(const FormulaHole& hole, const PotentialStart& start, bool sky, Long nearest_root)
        : LegEnds{sky, nearest_root}, hole_(hole), q_(start.q) {}
    const FormulaHole& hole_;
    Long q_;
};

// From a turning point: e + side t, t = gamma sinh^2(w)
class TurningLeg : public FormulaLeg {
public:
    TurningLeg(const FormulaHole& hole, const PotentialStart& start)
        : FormulaLeg(hole, start, start.beyond < 0, 0), side_(to_sky ? -1 : 1) {
        const Turn at = turning_point(hole, start);
        turn_ = at.zeta;
        v_turn_ = hole.v(turn_);
        const Long slope = -side_ * hole.v_slope(turn_), second = -hole.v_bend(turn_) / 2;
        gamma_ = second > 0 ? std::min(slope / second, turn_) : turn_;
        turn = static_cast<double>(turn_);
        nearest = to_sky ? turn_ : 0;
        camera = w_of(camera_distance(start, at, side_, [this](Long t) { return over(t); }));
        end = w_of(to_sky ? turn_ : hole.horizon - turn_);
    }
    double zeta(double w) const { return static_cast<double>(turn_ + side_ * t_of(w)); }
    double rate(double w) const {
        const Long t = t_of(w);
        return static_cast<double>(2 * std::sqrt(gamma_ / over(t)) * std::cosh(Long(w)) *
                                   hole_.density(turn_ + side_ * t));
    }
    double near_sky(double w) const {
        const Long a = end, b = w;
        return static_cast<double>(gamma_ * 2 * std::cosh((a + b) / 2) * std::sinh((a - b) / 2) *
                                   (std::sinh(a) + std::sinh(b)));
    }

private:
    Long t_of(double w) const { return gamma_ * std::sinh(Long(w)) * std::sinh(Long(w)); }
    double w_of(Long t) const { return static_cast<double>(std::asinh(std::sqrt(std::max(t, Long(0)) / gamma_))); }
    Long over(Long t) const {  // (q^2 - V)/t
        if (!(t > 1e-18L * turn_)) return -side_ * hole_.v_slope(turn_);
        return side_ * hole_.mean_fall(turn_, v_turn_, side_ * t);
    }
    int side_;  // of the photon sphere that the turning point lies on: -1 further out
    Long turn_, v_turn_, gamma_;
};

// q > q_crit: monotone over the photon sphere.
class PassingLeg : public FormulaLeg {
public:
    PassingLeg(const FormulaHole& hole, const PotentialStart& start)
        : FormulaLeg(hole, start, start.s < 0, hole.sphere),
          delta2_(start.delta2),
          epsilon_(std::sqrt(delta2_ / (-hole.v_bend(hole.sphere) / 2))) {
        camera = w_of(start.beyond);
        end = w_of(to_sky ? -hole.sphere : hole.horizon - hole.sphere);
    }
    double zeta(double w) const { return static_cast<double>(hole_.sphere + off(w)); }
    double rate(double w) const {
        const Long x = off(w);
        return static_cast<double>(epsilon_ * std::cosh(Long(w)) / std::sqrt(delta2_ + hole_.below(x)) *
                                   hole_.density(hole_.sphere + x));
    }
    double near_sky(double w) const {
        const Long a = end, b = w;
        return static_cast<double>(epsilon_ * 2 * std::cosh((a + b) / 2) * std::sinh((b - a) / 2));
    }

private:
    double w_of(Long off) const { return static_cast<double>(std::asinh(off / epsilon_)); }
    Long off(double w) const { return epsilon_ * std::sinh(Long(w)); }
    Long delta2_, epsilon_;
};

class FormulaOrbits : public PotentialMetric<FormulaHole> {
public:
    using PotentialMetric::PotentialMetric;
    double lapse(double r) const override { return static_cast<double>(std::sqrt(hole_.lapse2(r))); }
    // In double: the disc's light asks for it millions of times, and needs no more.
    EquatorialMetric equator(double r) const override {
        const double lapse2 = hole_.a.value<double>(r);
        return {-lapse2, 0, r * r, 1 / lapse2};
    }
    double within_last_circle() const override { return static_cast<double>(1.02L / hole_.sphere); }
    double beyond_last_circle() const override { return static_cast<double>(hole_.outermost_circle); }

private:
    std::unique_ptr<Orbit> swept(const PotentialStart& start) const override {
        if (start.delta2 > 0) return std::make_unique<LeggedOrbit<PassingLeg>>(hole_, start);
        return std::make_unique<LeggedOrbit<TurningLeg>>(hole_, start);
    }
};

}  // namespace

Result<std::unique_ptr<Metric>> make_formula_orbits(const SpacetimeSpec& spec) {
    TRY(hole, FormulaHole::of(spec));
    return std::unique_ptr<Metric>(std::make_unique<FormulaOrbits>(std::move(*hole)));
}

}  // namespace nullscope::reference
