// A ray in any static spherical metric, as Bouguer's law has it: psi its angle from the outward radial for observers at rest, sigma its proper
// length over R,
//     r' = R cos(psi)/sqrt(B),  phi' = sin(psi),  psi' = -sin(psi)/sqrt(B) (R_r - R A_r/(2 A)),
// by steps of Fehlberg's orders 7 and 8 in long double, inward and out again, whatever turns it. Far out the rest of phi is a quadrature in
// 1/r, through a cosmological horizon where there is one. A ray ends where A is next to nothing, or where a formula does.
#include "reference/formula_way.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "expr/smooth.h"
#include "reference/fehlberg.h"
#include "reference/smooth_segment.h"

namespace nullscope::reference {
namespace {

constexpr Long kWayError = 1e-16L;  // of a step: of r, and rad
constexpr Long kNoLapse2 = 1e-14L;  // of A, where light is taken to have ended
constexpr Long kLeastWayRadius = 1e-9L;
constexpr Long kLeastStep = 1e-9L;  // of sigma: a formula ends there
constexpr Long kWayFar = 1e4L;      // r from which on rays are followed by 1/r
constexpr Long kOnItsWay = 0.3L;    // cos(psi) of those
constexpr int kMostWaySteps = 100000;

using Slope = expr::Series<Long, 2>;

struct WayFormulas {
    expr::SmoothFormula a;
    std::optional<expr::SmoothFormula> b, areal;

    Long lapse2(Long r) const { return a.value<Long>(r); }
    Long stretch2(Long r) const { return b ? b->value<Long>(r) : 1 / lapse2(r); }
    Long radius(Long r) const { return areal ? areal->value<Long>(r) : r; }
    Long v(Long r) const { return lapse2(r) / (radius(r) * radius(r)); }
};

struct WayState {  // r, psi, phi
    std::array<Long, 3> at{};
    Long r() const { return at[0]; }
    Long psi() const { return at[1]; }
    Long phi() const { return at[2]; }
};

WayState stepped(const WayFormulas& f, const WayState& from, Long step, Long& wrong) {
    std::array<Long, 3> error{};
    const auto slope = [&f](const std::array<Long, 3>& y) {
        const Slope at = Slope::variable(y[0]), a = f.a.value<Long>(at),
                    across = f.areal ? f.areal->value<Long>(at) : at;
        const Long length = std::sqrt(f.stretch2(y[0])), sine = std::sin(y[1]), radius = across.of_power(0);
        return std::array<Long, 3>{radius * std::cos(y[1]) / length,
                                   -sine / length * (across.of_power(1) - radius * a.of_power(1) / (2 * a.of_power(0))),
                                   sine};
    };
    const WayState to{fehlberg(from.at, step, slope, error)};
    wrong = std::abs(error[0]) / std::abs(to.r()) + std::abs(error[1]) + std::abs(error[2]);
    if (!std::isfinite(to.r() + to.psi() + to.phi()) || !(to.r() > 0)) wrong = std::numeric_limits<Long>::quiet_NaN();
    return to;
}

struct WayStart {
    Long r, q, psi;
};

class FormulaWay final : public Orbit {
public:
    FormulaWay(const WayFormulas& f, const WayStart& start, Long far)
        : Orbit(static_cast<double>(1 / start.r)), f_(f), q_(start.q) {
        WayState now{{start.r, start.psi, 0}};
        Long step = 0.1L, wrong = 0;
        ways_.push_back(now);
        for (int i = 0; i < kMostWaySteps; ++i) {
            if (std::cos(now.psi()) > kOnItsWay && now.r() >= far) {
                escape(now);
                return;
            }
            if (!(f.lapse2(now.r()) > kNoLapse2) || now.r() < kLeastWayRadius || step < kLeastStep) break;
            const WayState next = stepped(f, now, step, wrong);
            const Long factor = wrong > 0    ? 0.9L * std::pow(kWayError / wrong, Long(0.125))
                                : wrong == 0 ? 4
                                             : Long(0.2);
            if (wrong <= kWayError) {
                if (std::cos(now.psi()) < 0 && std::cos(next.psi()) >= 0) turn_between(now, step);
                steps_.push_back(step);
                ways_.push_back(now = next);
            }
            step *= std::clamp(factor, Long(0.2), Long(2));
            step = std::min(step, Long(0.5));
        }
        fate_ = Fate::kCaptured;
        angle_ = static_cast<double>(now.phi());
    }
    double delay() const override { return kNotANumber; }

private:
    void escape(const WayState& now) {
        fate_ = Fate::kEscaped;
        angle_ = static_cast<double>(now.phi() + rest(now.r()));
    }
    // Swept from r outward, by octaves of 1/r: what is not a power of that far out is smooth in each.
    Long rest(Long r) const {
        constexpr int kOctaves = 50;
        const auto rate = [&](double inverse) {
            const Long place = 1 / Long(inverse), part = place / f_.radius(place);
            return static_cast<double>(part * part * std::sqrt(f_.lapse2(place) * f_.stretch2(place)) /
                                       std::sqrt(q_ * q_ - f_.v(place)));
        };
        double sum = 0, high = static_cast<double>(1 / r);
        for (int i = 0; i < kOctaves; ++i, high /= 2) sum += PanelGauss::integrate(rate, high / 2, high);
        return sum + high * rate(high);
    }
    void turn_between(const WayState& from, Long step) {
        Long low = 0, high = step, wrong = 0;
        for (int i = 0; i < 60; ++i) {
            const Long middle = (low + high) / 2;
            (std::cos(stepped(f_, from, middle, wrong).psi()) < 0 ? low : high) = middle;
        }
        const WayState there = stepped(f_, from, high, wrong);
        turn_ = static_cast<double>(1 / there.r()), turn_angle_ = static_cast<double>(there.phi());
    }
    double place_at(double angle) const override {
        const auto after = std::upper_bound(ways_.begin(), ways_.end(), Long(angle),
                                            [](Long phi, const WayState& way) { return phi < way.phi(); });
        if (after == ways_.end()) return far_place(angle);
        const auto i = static_cast<std::size_t>(after - ways_.begin()) - 1;
        Long step = steps_[i] * (angle - ways_[i].phi()) / (ways_[i + 1].phi() - ways_[i].phi()), wrong = 0;
        WayState there = ways_[i];
        for (int k = 0; k < 8; ++k) {  // Newton's steps
            there = stepped(f_, ways_[i], step, wrong);
            const Long off = there.phi() - angle;
            step -= off / std::sin(there.psi());
            if (std::abs(off) < 1e-17L) break;
        }
        return static_cast<double>(1 / there.r());
    }
    // 1/r whose rest is what is left.
    double far_place(double angle) const {
        double low = 0, high = static_cast<double>(1 / ways_.back().r());
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            (rest(1 / Long(middle)) < angle_ - angle ? low : high) = middle;
        }
        return high;
    }
    const WayFormulas& f_;
    Long q_;
    std::vector<WayState> ways_;
    std::vector<Long> steps_;
};

class FormulaWays final : public OrbitMetric {
public:
    explicit FormulaWays(WayFormulas f) : f_(std::move(f)) {}
    double lapse(double r) const override { return static_cast<double>(std::sqrt(f_.lapse2(r))); }
    Result<std::unique_ptr<Orbit>> from_reduced(const ReducedRay& ray) const override {
        const Long r = 1 / Long(ray.zeta0), sine = std::sqrt(f_.lapse2(r)) / (f_.radius(r) * ray.q);
        if (!(sine * sine < 1 + kTurningSlack)) return no_such_ray(ray, "zeta0", ": q^2 < V(zeta0)");
        return way(r, ray.q, std::asin(std::min(sine, Long(1))), ray.s > 0);
    }
    std::unique_ptr<Orbit> from_static(const LocalRay& ray) const override {
        const Long q = std::sqrt(f_.lapse2(ray.r)) / (f_.radius(ray.r) * ray.n_t);
        return way(ray.r, q, std::atan2(Long(ray.n_t), std::abs(Long(ray.n_r))), ray.n_r <= 0);
    }
    RainOrbit from_rain(const LocalRay& ray) const override {
        const Long a = f_.lapse2(ray.r), w = std::sqrt(1 - a);
        const auto [energy, outward] = RainStart<Long>(ray, w, -a / (1 + w));
        if (!(energy > 0)) return {std::make_unique<StandingOrbit>(1 / ray.r, Fate::kNoSky), kNotANumber};
        const Long q = energy / (f_.radius(ray.r) * ray.n_t);
        return {way(ray.r, q, std::atan2(std::sqrt(a) * Long(ray.n_t), std::abs(outward)), !(outward > 0)),
                static_cast<double>(1 / energy)};
    }

private:
    // The traced ray goes inward or outward from the camera, at the angle acute from the radial direction.
    std::unique_ptr<Orbit> way(Long r, Long q, Long acute, bool inward) const {
        if (!(acute > 0) && !inward) return std::make_unique<StandingOrbit>(static_cast<double>(1 / r), Fate::kEscaped);
        const Long pi = std::acos(Long(-1)), psi = inward ? pi - std::max(acute, Long(1e-30L)) : acute;
        return std::make_unique<FormulaWay>(f_, WayStart{r, q, psi}, far_from(r));
    }
    // Half way to a cosmological horizon, if that is nearer than kWayFar.
    Long far_from(Long r) const {
        for (Long out = r; out < 2 * kWayFar; out *= 1.05L)
            if (!(f_.lapse2(out) > 0)) return std::max(r, out / 2);
        return kWayFar;
    }
    WayFormulas f_;
};

}  // namespace

Result<std::unique_ptr<Metric>> make_formula_ways(const SpacetimeSpec& spec) {
    WayFormulas f;
    for (const auto& [name, text] : spec.parameters.formulas) {
        if (text.empty()) continue;
        TRY(parsed, expr::SmoothFormula::parse(text, "r"));
        if (name == "A") f.a = *parsed;
        if (name == "B") f.b = *parsed;
        if (name == "R") f.areal = *parsed;
    }
    return std::unique_ptr<Metric>(std::make_unique<FormulaWays>(std::move(f)));
}

}  // namespace nullscope::reference
