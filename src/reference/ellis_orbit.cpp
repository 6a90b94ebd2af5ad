// Ellis wormhole orbits in closed form: (dl/dphi)^2 = (l^2 + 1)(l^2 + 1 - b^2)/b^2, lengths in throat radii (scaled by the throat's
// radius where that is not 1), q = 1/b.
//
// b > 1: the ray turns. With alpha the angle from the outward radial direction on its own side, sin(alpha) = b/sqrt(l^2 + 1):
//     phi = F(alpha | 1/b^2) counted from that side's sky, 2 K(1/b^2) in all.
// b < 1: it passes the throat. With sin(psi) = 1/sqrt(l^2 + 1), psi from 0 (l = +infinity) to pi (l = -infinity):
//     phi = b F(psi | b^2), 2 b K(b^2) in all.
#include <algorithm>
#include <cmath>

#include "reference/elliptic.h"
#include "reference/plane_metrics.h"
#include "reference/smooth_segment.h"

namespace nullscope::reference {
namespace {

// T beyond l >= 2 max(b, 1) > 0: (1/s - 1) dl with s = sqrt(1 - b^2/R^2), in x = 1/l.
double far_delay(double b, double l) {
    return integrate_panels(
        [b](double x) {
            const double r2 = 1 + x * x, s = std::sqrt(1 - b * x * b * x / r2);  // R^2 x^2
            return b * b / (r2 * s * (1 + s));
        },
        0, 1 / l);
}

class EllisRay : public Orbit {
protected:
    EllisRay(const ThroatStart& start, double throat)
        : Orbit(throat * static_cast<double>(start.l)),
          start_(start),
          l_(static_cast<double>(start.l)),
          b_(static_cast<double>(start.b)),
          throat_(throat) {}
    ThroatStart start_;
    double l_, b_, throat_;
};

class Turning : public EllisRay {  // b > 1
public:
    Turning(const ThroatStart& start, double throat)
        : EllisRay(start, throat), turn_l_(static_cast<double>(std::sqrt(start.turn2))) {
        side_ = l_ < 0 ? -1 : 1;
        m1_ = static_cast<double>(start.turn2 / (Long(b_) * b_));
        quarter_ = rf(0, m1_, 1);
        const Long r2 = Long(l_) * l_ + 1;
        const double f = static_cast<double>(b_ / std::sqrt(r2)) *
                         rf(static_cast<double>(start.away2 / r2), static_cast<double>(Long(l_) * l_ / r2), 1);
        inward_ = start.outward != (side_ > 0);
        angle_ = inward_ ? 2 * quarter_ - f : f;
        fate_ = side_ > 0 ? Fate::kEscaped : Fate::kOtherSide;
        if (inward_) turn_ = throat * (side_ * turn_l_);
    }
    double place_at(double angle) const override {
        const double rest = angle_ - angle;
        const JacobiValues j = jacobi(std::min(rest, 2 * quarter_ - rest), m1_);
        return throat_ * (side_ * b_ * j.dn / j.sn);
    }
    // Twice the way in, and what an outward ray has from the camera on. l = turn cosh(w): dl/s = R dw, (1/s - 1) dl = b^2 dw/(R + turn
    // sinh w).
    double delay() const override {
        const double l = std::abs(l_), b = b_, t = turn_l_, middle = std::max(l, 2 * b);
        const double here = std::asinh(static_cast<double>(std::sqrt(start_.away2)) / t);
        const auto radius = [t](double w) { return std::hypot(t * std::cosh(w), 1.0); };
        double sum = far_delay(b, middle);
        if (middle > l)
            sum += integrate_panels([&](double w) { return b * b / (radius(w) + t * std::sinh(w)); }, here,
                                    std::acosh(std::max(middle / t, 1.0)));
        return throat_ * (inward_ ? sum + 2 * integrate_panels(radius, 0, here) : sum);
    }

private:
    double turn_l_, side_, m1_, quarter_;
    bool inward_ = false;
};

class EllisPassing : public EllisRay {  // b < 1
public:
    EllisPassing(const ThroatStart& start, double throat)
        : EllisRay(start, throat), m1_(static_cast<double>(-start.turn2)) {
        quarter_ = rf(0, m1_, 1);
        const Long r2 = Long(l_) * l_ + 1;
        const double f = static_cast<double>(1 / std::sqrt(r2)) *
                         rf(static_cast<double>(Long(l_) * l_ / r2), static_cast<double>(start.away2 / r2), 1);
        const bool leaves = start.outward == (l_ >= 0);  // without passing the throat
        angle_ = b_ * (leaves ? f : 2 * quarter_ - f);
        fate_ = start.outward ? Fate::kEscaped : Fate::kOtherSide;
    }
    double place_at(double angle) const override {
        const double rest = (angle_ - angle) / b_, sign = start_.outward ? 1 : -1;
        const bool past = rest <= quarter_;
        const JacobiValues j = jacobi(past ? rest : 2 * quarter_ - rest, m1_);
        return throat_ * ((past ? sign : -sign) * j.cn / j.sn);
    }
    // l = c sinh(w), c = sqrt(1 - b^2): (1/s - 1) dl = b^2 dw/(R + c cosh w). Elapsed time minus the way from l to L as |L| grows; for a
    // ray that ends on the side it did not start from, minus L + |l|: the same integral.
    double delay() const override {
        const double c = std::sqrt(m1_), b = b_, along = start_.outward ? l_ : -l_, middle = std::max(along, 2.0);
        double sum = far_delay(b, middle);
        if (middle > along)
            sum += integrate_panels(
                [=](double w) { return b * b / (std::hypot(c * std::sinh(w), 1.0) + c * std::cosh(w)); },
                std::asinh(along / c), std::asinh(middle / c));
        return throat_ * sum;
    }

private:
    double m1_, quarter_;
};

class Ellis : public OrbitMetric {
public:
    explicit Ellis(double throat) : throat_(throat) {}
    bool by_proper_length() const override { return true; }
    double lapse(double) const override { return 1; }
    Result<std::unique_ptr<Orbit>> from_reduced(const ReducedRay& ray) const override {
        const Long l0 = ray.zeta0 / throat_;
        if (std::isinf(ray.q)) return orbit({l0, 0, outward(ray), -1, 1});
        const Long b = 1 / (Long(ray.q) * throat_), l = Long(ray.zeta0) / throat_, away2 = (l * l + (1 - b) * (1 + b));
        if (away2 < -kTurningSlack * b * b) return no_such_ray(ray, "l0");
        return orbit({l0, b, outward(ray), (b - 1) * (b + 1), std::max(away2, Long(0))});
    }
    std::unique_ptr<Orbit> from_static(const LocalRay& ray) const override {
        const Long l = Long(ray.r) / throat_, n_r = ray.n_r, n_t = ray.n_t, r2 = l * l + 1;
        return orbit({l, std::sqrt(r2) * n_t, ray.n_r > 0,
                      (std::abs(l) * n_t - std::abs(n_r)) * (std::abs(l) * n_t + std::abs(n_r)), r2 * n_r * n_r});
    }

private:
    std::unique_ptr<Orbit> orbit(const ThroatStart& at) const {
        return orbit_through_throat(at, 1, throat_, [this](const ThroatStart& start) -> std::unique_ptr<Orbit> {
            if (start.turn2 > 0) return std::make_unique<Turning>(start, throat_);
            return std::make_unique<EllisPassing>(start, throat_);
        });
    }
    double throat_;
};

}  // namespace

OrbitMetricPtr make_ellis_orbits(const SpacetimeSpec& spec) {
    return std::make_unique<Ellis>(parameter_of(spec, "throat", 1.0));
}

}  // namespace nullscope::reference
