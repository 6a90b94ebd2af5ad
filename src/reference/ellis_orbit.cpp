#include "reference/ellis_orbit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/elliptic.h"
#include "reference/smooth_leg.h"

namespace nullscope::reference {
namespace {

using Long = long double;
constexpr double kRadialImpact = 1e-60;  // below it a ray is radial
constexpr double kTurningSlack = 16 * std::numeric_limits<double>::epsilon();

// At the camera. turn2 = b^2 - 1 and away2 = R^2 - b^2 >= 0 do not follow from l and b in double. outward: towards growing l.
struct Start {
    double l, b;
    bool outward;
    Long turn2, away2;
};

// T beyond l >= 2 max(b, 1) > 0: (1/s - 1) dl with s = sqrt(1 - b^2/R^2), in x = 1/l.
double far_delay(double b, double l) {
    return integrate_panels(
        [b](double x) {
            const double r2 = 1 + x * x, s = std::sqrt(1 - b * x * b * x / r2);  // R^2 x^2
            return b * b / (r2 * s * (1 + s));
        },
        0, 1 / l);
}

class Turning : public Orbit {  // b > 1
public:
    explicit Turning(const Start& start) : start_(start), turn_l_(static_cast<double>(std::sqrt(start.turn2))) {
        side_ = start.l < 0 ? -1 : 1;
        m1_ = static_cast<double>(start.turn2 / (Long(start.b) * start.b));
        quarter_ = rf(0, m1_, 1);
        const Long r2 = Long(start.l) * start.l + 1;
        const double f =
            static_cast<double>(start.b / std::sqrt(r2)) *
            rf(static_cast<double>(start.away2 / r2), static_cast<double>(Long(start.l) * start.l / r2), 1);
        inward_ = start.outward != (side_ > 0);
        angle_ = inward_ ? 2 * quarter_ - f : f;
        fate_ = side_ > 0 ? Fate::kEscaped : Fate::kOtherSide;
        if (inward_) turn_ = side_ * turn_l_;
    }
    double zeta_at(double angle) const override {
        if (angle == 0) return start_.l;
        if (has_ended(angle)) return kNotANumber;
        const double rest = angle_ - angle;
        const JacobiValues j = jacobi(std::min(rest, 2 * quarter_ - rest), m1_);
        return side_ * start_.b * j.dn / j.sn;
    }
    // Twice the way in, and what an outward ray has from the camera on. l = turn cosh(w): dl/s = R dw, (1/s - 1) dl = b^2 dw/(R + turn
    // sinh w).
    double delay() const override {
        const double l = std::abs(start_.l), b = start_.b, t = turn_l_, middle = std::max(l, 2 * b);
        const double here = std::asinh(static_cast<double>(std::sqrt(start_.away2)) / t);
        const auto radius = [t](double w) { return std::hypot(t * std::cosh(w), 1.0); };
        double sum = far_delay(b, middle);
        if (middle > l)
            sum += integrate_panels([&](double w) { return b * b / (radius(w) + t * std::sinh(w)); }, here,
                                    std::acosh(std::max(middle / t, 1.0)));
        return inward_ ? sum + 2 * integrate_panels(radius, 0, here) : sum;
    }

private:
    Start start_;
    double turn_l_, side_, m1_, quarter_;
    bool inward_ = false;
};

class Passing : public Orbit {  // b < 1
public:
    explicit Passing(const Start& start) : start_(start), m1_(static_cast<double>(-start.turn2)) {
        quarter_ = rf(0, m1_, 1);
        const Long r2 = Long(start.l) * start.l + 1;
        const double f = static_cast<double>(1 / std::sqrt(r2)) * rf(static_cast<double>(Long(start.l) * start.l / r2),
                                                                     static_cast<double>(start.away2 / r2), 1);
        const bool leaves = start.outward == (start.l >= 0);  // without passing the throat
        angle_ = start.b * (leaves ? f : 2 * quarter_ - f);
        fate_ = start.outward ? Fate::kEscaped : Fate::kOtherSide;
    }
    double zeta_at(double angle) const override {
        if (angle == 0) return start_.l;
        if (has_ended(angle)) return kNotANumber;
        const double rest = (angle_ - angle) / start_.b, sign = start_.outward ? 1 : -1;
        if (rest <= quarter_) {
            const JacobiValues j = jacobi(rest, m1_);
            return sign * j.cn / j.sn;
        }
        const JacobiValues j = jacobi(2 * quarter_ - rest, m1_);
        return -sign * j.cn / j.sn;
    }
    // l = c sinh(w), c = sqrt(1 - b^2): (1/s - 1) dl = b^2 dw/(R + c cosh w). Elapsed time minus the way from l to L as |L| grows; for a
    // ray that ends on the side it did not start from, minus L + |l|: the same integral.
    double delay() const override {
        const double c = std::sqrt(m1_), b = start_.b, along = start_.outward ? start_.l : -start_.l,
                     middle = std::max(along, 2.0);
        double sum = far_delay(b, middle);
        if (middle > along)
            sum += integrate_panels(
                [=](double w) { return b * b / (std::hypot(c * std::sinh(w), 1.0) + c * std::cosh(w)); },
                std::asinh(along / c), std::asinh(middle / c));
        return sum;
    }

private:
    Start start_;
    double m1_, quarter_;
};

class Straight : public Orbit {  // radial rays, and the circle at the throat
public:
    Straight(double l, Fate fate) : l_(l) {
        fate_ = fate;
        if (fate != Fate::kNoSky) angle_ = 0;
    }
    double zeta_at(double angle) const override { return angle == 0 || fate_ == Fate::kNoSky ? l_ : kNotANumber; }
    double delay() const override { return fate_ == Fate::kNoSky ? kNotANumber : 0; }

private:
    double l_;
};

// The same orbit with another unit of length.
class Scaled : public Orbit {
public:
    Scaled(std::unique_ptr<Orbit> unit, double length) : unit_(std::move(unit)), length_(length) {
        fate_ = unit_->fate();
        angle_ = unit_->angle();
        turn_ = length * unit_->turn();
        turn_angle_ = unit_->turn_angle();
    }
    double zeta_at(double angle) const override { return length_ * unit_->zeta_at(angle); }
    double delay() const override { return length_ * unit_->delay(); }

private:
    std::unique_ptr<Orbit> unit_;
    double length_;
};

class Ellis : public OrbitMetric {
public:
    explicit Ellis(double throat) : throat_(throat) {}
    std::optional<double> horizon_radius() const override { return {}; }
    bool by_proper_length() const override { return true; }
    double lapse(double) const override { return 1; }
    Result<std::unique_ptr<Orbit>> from_reduced(const ReducedRay& ray) const override {
        const double l0 = ray.zeta0 / throat_;
        if (std::isinf(ray.q)) return scaled({l0, 0, outward(ray), -1, 1});
        const Long b = 1 / (Long(ray.q) * throat_), l = Long(ray.zeta0) / throat_, away2 = (l * l + (1 - b) * (1 + b));
        if (away2 < -kTurningSlack * b * b)
            return bad_input(fmt::format("no ray with q = {:.17g} passes through l0 = {:.17g}", ray.q, ray.zeta0));
        return scaled({l0, static_cast<double>(b), outward(ray), (b - 1) * (b + 1), std::max(away2, Long(0))});
    }
    std::unique_ptr<Orbit> from_static(const LocalRay& ray) const override {
        const Long l = Long(ray.r) / throat_, n_r = ray.n_r, n_t = ray.n_t, r2 = l * l + 1;
        return scaled({static_cast<double>(l), static_cast<double>(std::sqrt(r2) * n_t), ray.n_r > 0,
                       (std::abs(l) * n_t - std::abs(n_r)) * (std::abs(l) * n_t + std::abs(n_r)), r2 * n_r * n_r});
    }
    RainOrbit from_rain(const LocalRay& ray) const override { return {from_static(ray), 1.0}; }  // nothing falls here

private:
    static bool outward(const ReducedRay& ray) {
        return (ray.s < 0) == (ray.zeta0 >= 0);
    }  // s = +1: towards the throat
    std::unique_ptr<Orbit> scaled(const Start& start) const {
        return throat_ == 1.0 ? orbit(start) : std::make_unique<Scaled>(orbit(start), throat_);
    }
    static std::unique_ptr<Orbit> orbit(Start start) {
        if (start.b < kRadialImpact)
            return std::make_unique<Straight>(start.l, start.outward ? Fate::kEscaped : Fate::kOtherSide);
        if (start.turn2 == 0 && start.away2 == 0) return std::make_unique<Straight>(start.l, Fate::kNoSky);
        if (start.turn2 == 0) start.turn2 = -std::pow(Long(std::numeric_limits<double>::epsilon()), 2);
        if (start.turn2 > 0) return std::make_unique<Turning>(start);
        return std::make_unique<Passing>(start);
    }
    double throat_;
};

}  // namespace

std::unique_ptr<OrbitMetric> make_ellis_orbits(const SpacetimeSpec& spec) {
    const auto throat = spec.parameters.find("throat");
    return std::make_unique<Ellis>(throat == spec.parameters.end() ? 1.0 : throat->second);
}

}  // namespace nullscope::reference
