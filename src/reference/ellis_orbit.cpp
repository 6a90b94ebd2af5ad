// Ellis wormhole orbits in closed form: (dl/dphi)^2 = (l^2 + 1)(l^2 + 1 - b^2)/b^2, lengths in throat radii (scaled by the throat's
// radius where that is not 1), q = 1/b.
//
// b > 1: the ray turns. With alpha the angle from the outward radial direction on its own side, sin(alpha) = b/sqrt(l^2 + 1):
//     phi = F(alpha | 1/b^2) counted from that side's sky, 2 K(1/b^2) in all.
// b < 1: it passes the throat. With sin(psi) = 1/sqrt(l^2 + 1), psi from 0 (l = +infinity) to pi (l = -infinity):
//     phi = b F(psi | b^2), 2 b K(b^2) in all.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/elliptic.h"
#include "reference/plane_metrics.h"
#include "reference/smooth_leg.h"

namespace nullscope::reference {
namespace {

constexpr double kRadialImpact = 1e-60;  // below it a ray is radial

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
    bool by_proper_length() const override { return true; }
    double lapse(double) const override { return 1; }
    Result<std::unique_ptr<Orbit>> from_reduced(const ReducedRay& ray) const override {
        const double l0 = ray.zeta0 / throat_;
        if (std::isinf(ray.q)) return scaled({l0, 0, outward(ray), -1, 1});
        const Long b = 1 / (Long(ray.q) * throat_), l = Long(ray.zeta0) / throat_, away2 = (l * l + (1 - b) * (1 + b));
        if (away2 < -kTurningSlack * b * b) return no_such_ray(ray, "l0");
        return scaled({l0, static_cast<double>(b), outward(ray), (b - 1) * (b + 1), std::max(away2, Long(0))});
    }
    std::unique_ptr<Orbit> from_static(const LocalRay& ray) const override {
        const Long l = Long(ray.r) / throat_, n_r = ray.n_r, n_t = ray.n_t, r2 = l * l + 1;
        return scaled({static_cast<double>(l), static_cast<double>(std::sqrt(r2) * n_t), ray.n_r > 0,
                       (std::abs(l) * n_t - std::abs(n_r)) * (std::abs(l) * n_t + std::abs(n_r)), r2 * n_r * n_r});
    }

private:
    static bool outward(const ReducedRay& ray) {
        return (ray.s < 0) == (ray.zeta0 >= 0);
    }  // s = +1: towards the throat
    std::unique_ptr<Orbit> scaled(const Start& start) const {
        return throat_ == 1.0 ? orbit(start) : std::make_unique<Scaled>(orbit(start), throat_);
    }
    static std::unique_ptr<Orbit> orbit(Start start) {
        if (start.b < kRadialImpact)
            return std::make_unique<StandingOrbit>(start.l, start.outward ? Fate::kEscaped : Fate::kOtherSide);
        if (start.turn2 == 0 && start.away2 == 0) return std::make_unique<StandingOrbit>(start.l, Fate::kNoSky, false);
        if (start.turn2 == 0) start.turn2 = -std::pow(Long(std::numeric_limits<double>::epsilon()), 2);
        if (start.turn2 > 0) return std::make_unique<Turning>(start);
        return std::make_unique<Passing>(start);
    }
    double throat_;
};

}  // namespace

OrbitMetricPtr make_ellis_orbits(const SpacetimeSpec& spec) {
    return std::make_unique<Ellis>(parameter_of(spec, "throat", 1.0));
}

}  // namespace nullscope::reference
