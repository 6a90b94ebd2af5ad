// Orbits about a hole given by formulas, by quadrature of dphi = sqrt(A B) (r/R)^2 dzeta/sqrt(q^2 - V), V = A/R^2, zeta = 1/r.
//
// Every orbit is one or two monotone segments, each in a variable w in which its integrand is smooth:
//   from a turning point e, zeta = e -+ gamma sinh^2(w): q^2 - V = t times the mean of V' over t, gamma the distance to the neighbouring
//       root as the first two derivatives at e tell it;
//   over the photon sphere, zeta = zeta_c + epsilon sinh(w): q^2 - V = delta2 + below(zeta - zeta_c);
//   next to the sky zeta itself.
// Panels of w with 20 Gauss nodes; formulas in long double, so that differences of V lose nothing that a double has, and where they are
// smooth, which is nearly everywhere, as sums of Chebyshev's polynomials, which have differences without loss: of V/zeta^2, and of
// (q_crit^2 - V)/(zeta - zeta_c)^2.
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "expr/smooth.h"
#include "reference/formula_way.h"
#include "reference/octave_sums.h"
#include "reference/potential_orbit.h"
#include "spacetime/registry.h"
#include "spacetime/spherical_metric.h"

namespace nullscope::reference {
namespace {

// What the reference knows of a hole that scene files give by formulas: A, B and R in long double, and the places that its orbits need.
struct FormulaHole {
    expr::SmoothFormula a;
    std::optional<expr::SmoothFormula> b, areal;
    Long horizon = 0, sphere = 0;  // zeta
    Long v_crit = 0, q_crit = 0;   // V at the photon sphere
    Long outermost_circle = 0;     // r up to which the energy of circles grows, or 100 horizons
    OctaveSums shape, hill;        // V/zeta^2; (v_crit - V)/(zeta - sphere)^2
    OctaveSums densities;          // where b or areal is given
    Long hill_at_sphere = 0;

    // Errors: a formula that cannot be read, no horizon.
    static Result<FormulaHole> of(const SpacetimeSpec& spec);

    Long lapse2(Long r) const { return a.value<Long>(r); }
    Long radius(Long r) const { return areal ? areal->value<Long>(r) : r; }
    Long fall_speed(Long r) const {
        return std::sqrt(1 - lapse2(r));
    }  // from rest at infinity; not a number: it repels
    bool has_circle() const { return true; }
    Long v_by_formula(Long zeta) const;
    Long v(Long zeta) const {
        const OctaveSums::Piece* piece = shape.piece(static_cast<double>(zeta));
        return piece ? zeta * zeta * (*piece)(zeta) : v_by_formula(zeta);
    }
    Long p(Long q, Long zeta) const { return q * q - v(zeta); }
    Long v_slope(Long zeta) const;      // by zeta
    Long v_bend(Long zeta) const;       // twice
    double density(double zeta) const;  // dphi = density dzeta/sqrt(q^2 - V)
    // V(turn) - V(turn + by) over by: the mean of -V' between. v_turn = V(turn).
    Long mean_fall(Long turn, Long v_turn, Long by) const;
    // v_crit - V(sphere + x): twice integrated, -x^2 times the mean of (1 - u) V'', where V is too near to its maximum for a difference.
    Long below_by_formula(Long x) const;
    Long below(Long x) const {
        const OctaveSums::Piece* piece = hill.piece(static_cast<double>(sphere + x));
        return piece ? x * x * (*piece)(sphere + x) : below_by_formula(x);
    }
    double below(double x) const {
        const double zeta = static_cast<double>(sphere) + x;
        const OctaveSums::Piece* piece = hill.piece(zeta);
        return piece ? x * x * (*piece)(zeta) : static_cast<double>(below_by_formula(x));
    }
    Long density_by_formula(Long zeta) const;
    void make_sums();
};

constexpr Long kLeastZeta = 1e-200L;  // stands for the sky: powers of r up to 24 are still numbers there

template <int n>
using Jet = expr::Series<Long, n>;
using Rule = boost::math::quadrature::gauss<Long, 10>;

constexpr Long kNear = 1e-2L;    // of V, below which differences of V have lost two digits of a long double's nineteen
constexpr int kSumOctaves = 30;  // from the horizon outward, in sums

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
    hole.make_sums();
    return hole;
}

void FormulaHole::make_sums() {
    hill_at_sphere = -v_bend(sphere) / 2;
    shape = {[this](Long zeta) { return v_by_formula(zeta) / (zeta * zeta); }, horizon, kSumOctaves};
    hill = {[this](Long zeta) { return below_by_formula(zeta - sphere) / ((zeta - sphere) * (zeta - sphere)); },
            horizon, kSumOctaves};
    if (b || areal) densities = {[this](Long zeta) { return density_by_formula(zeta); }, horizon, kSumOctaves};
}

Long FormulaHole::v_by_formula(Long zeta) const {
    const Long r = 1 / std::max(zeta, kLeastZeta), across = radius(r);
    return lapse2(r) / (across * across);
}
Long FormulaHole::v_slope(Long zeta) const { return v_jet<2>(*this, zeta).of_power(1); }
Long FormulaHole::v_bend(Long zeta) const { return 2 * v_jet<3>(*this, zeta).of_power(2); }

double FormulaHole::density(double zeta) const {
    if (!b && !areal) return 1;
    const OctaveSums::Piece* piece = densities.piece(zeta);
    return piece ? (*piece)(zeta) : static_cast<double>(density_by_formula(zeta));
}

Long FormulaHole::density_by_formula(Long zeta) const {
    const Long r = 1 / std::max(zeta, kLeastZeta), part = r / radius(r);
    return std::sqrt(b ? lapse2(r) * b->value<Long>(r) : Long(1)) * part * part;
}

Long FormulaHole::mean_fall(Long turn, Long v_turn, Long by) const {
    const Long fall = v_turn - v_by_formula(turn + by);
    if (std::abs(fall) > kNear * v_turn) return fall / by;
    return -Rule::integrate([&](Long u) { return v_slope(turn + u * by); }, Long(0), Long(1));
}

Long FormulaHole::below_by_formula(Long x) const {
    const Long whole = v_crit - v_by_formula(sphere + x);
    if (whole > kNear * v_crit) return whole;
    return -x * x * Rule::integrate([&](Long u) { return (1 - u) * v_bend(sphere + u * x); }, Long(0), Long(1));
}

class FormulaLeg : public LegEnds {
public:
    double sky_rate(double z) const { return hole_.density(z) / static_cast<double>(std::sqrt(q_ * q_ - hole_.v(z))); }

protected:
    FormulaLeg(const FormulaHole& hole, const PotentialStart& start, bool sky, Long nearest_root)
        : LegEnds{sky, nearest_root}, hole_(hole), q_(start.q) {}
    const FormulaHole& hole_;
    Long q_;
};

// (q^2 - V)/t, t the distance from a turning point e, V(e) = q^2; side -1: t outward, else inward.
// With f = V/zeta^2 where e is far out, else (q_crit^2 - V)/(zeta - zeta_c)^2, x = zeta or zeta - zeta_c, and x_e that of e,
//     x^2 f - x_e^2 f(e) = (x - x_e) [(x + x_e) f(e) + x^2 f[zeta, e]],
// where the first term is at least of the size of the sum.
class RiseFromTurn {
public:
    RiseFromTurn(const FormulaHole& hole, const Turn& turn, int side)
        : hole_(hole),
          turn_(turn.zeta),
          side_(side),
          far_(side < 0 && turn.zeta < hole.sphere / 2),
          sums_(far_ ? hole.shape : hole.hill),
          from_(static_cast<double>(far_ ? turn.zeta : turn.off)),
          turned_(static_cast<double>(turn.zeta)) {
        const OctaveSums::Piece* piece = sums_.piece(turned_);
        if (!piece) return;
        differences_.emplace(*piece, turn_);
        at_turn_ = static_cast<double>((*piece)(turn_));
    }
    double operator()(double t) const {
        const double zeta = turned_ + side_ * t, x = from_ + side_ * t;
        if (differences_ && differences_->holds(zeta))
            return (far_ ? 1 : side_) * ((x + from_) * at_turn_ + x * x * (*differences_)(zeta));
        if (const OctaveSums::Piece* piece = differences_ ? sums_.piece(zeta) : nullptr)
            return (far_ ? -1 : 1) * (x * x * (*piece)(zeta)-from_ * from_ * at_turn_) / t;
        return static_cast<double>(by_formula(t));
    }

private:
    Long by_formula(Long t) const {
        if (!(t > 1e-18L * turn_)) return -side_ * hole_.v_slope(turn_);
        return side_ * hole_.mean_fall(turn_, hole_.v_by_formula(turn_), side_ * t);
    }
    const FormulaHole& hole_;
    Long turn_;
    int side_;
    bool far_;
    const OctaveSums& sums_;
    double from_, turned_, at_turn_ = 0;
    std::optional<OctaveDifferences> differences_;
};

// From a turning point: e + side t, t = gamma sinh^2(w)
class TurningLeg : public FormulaLeg {
public:
    TurningLeg(const FormulaHole& hole, const PotentialStart& start)
        : TurningLeg(hole, start, turning_point(hole, start)) {}
    double zeta(double w) const {
        const Long sine = std::sinh(Long(w));
        return static_cast<double>(turn_ + side_ * gamma_ * sine * sine);
    }
    double rate(double w) const {
        const double sine = std::sinh(w), sinh2 = sine * sine, t = gamma_ * sinh2;
        return 2 * std::sqrt(gamma_ / over_(t) * (1 + sinh2)) * hole_.density(turn + side_ * t);
    }
    double near_sky(double w) const {
        const Long a = end, b = w, gamma = gamma_;
        return static_cast<double>(gamma * 2 * std::cosh((a + b) / 2) * std::sinh((a - b) / 2) *
                                   (std::sinh(a) + std::sinh(b)));
    }

private:
    TurningLeg(const FormulaHole& hole, const PotentialStart& start, const Turn& at)
        : FormulaLeg(hole, start, start.beyond < 0, 0), side_(to_sky ? -1 : 1), turn_(at.zeta), over_(hole, at, side_) {
        turn = static_cast<double>(turn_);
        const double slope = over_(0), step = kGammaStep * turn, second = (over_(step) - slope) / step;
        gamma_ = second > 0 ? std::min(slope / second, turn) : turn;
        nearest = to_sky ? turn_ : 0;
        camera = w_of(camera_distance(start, at, side_, [this](Long t) { return over_(static_cast<double>(t)); }));
        end = w_of(to_sky ? turn_ : hole.horizon - turn_);
    }
    double w_of(Long t) const { return static_cast<double>(std::asinh(std::sqrt(std::max(t, Long(0)) / gamma_))); }
    int side_;  // of the photon sphere that the turning point lies on: -1 further out
    Long turn_;
    RiseFromTurn over_;
    double gamma_ = 0;
    static constexpr double kGammaStep = 1e-4;  // of the turning point: for the second derivative there, to as much
};

// q > q_crit: monotone over the photon sphere.
class PassingLeg : public FormulaLeg {
public:
    PassingLeg(const FormulaHole& hole, const PotentialStart& start)
        : FormulaLeg(hole, start, start.s < 0, hole.sphere),
          delta2_(start.delta2),
          epsilon_(std::sqrt(delta2_ / hole.hill_at_sphere)) {
        camera = w_of(start.beyond);
        end = w_of(to_sky ? -hole.sphere : hole.horizon - hole.sphere);
    }
    double zeta(double w) const { return static_cast<double>(hole_.sphere + off(w)); }
    double rate(double w) const {
        const double sine = std::sinh(w), x = static_cast<double>(epsilon_) * sine;
        return std::sqrt((1 + sine * sine) / ((static_cast<double>(delta2_) + hole_.below(x)))) *
               static_cast<double>(epsilon_) * hole_.density(static_cast<double>(hole_.sphere) + x);
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
    TRY(spacetime, make_spacetime(spec.metric, spec.parameters));
    if ((*spacetime)->spherical()->potential() != nullptr) return make_formula_ways(spec);
    TRY(hole, FormulaHole::of(spec));
    return std::unique_ptr<Metric>(std::make_unique<FormulaOrbits>(std::move(*hole)));
}

}  // namespace nullscope::reference
